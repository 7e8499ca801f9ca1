package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;

/**
 * Derivatives of dependent velocities and accelerations of a moving loop by the independent ones: v
 * = R v_I + V ξ_I, a = R a_I + A_v v_I + A_q ξ_I for small ξ. All three are zero at rest. With
 * non-holonomic equations there are more independent ξ_I than v_I.
 *
 * <p>J v + Φ_t and J a + γ are varied by central differences of three steps, extrapolated; they are
 * quadratic in v, so that one step is exact.
 */
public final class LoopVariations {
  private static final double STEP = 4e-3;

  private final EquationsOfMotion equations;
  private final FreeDirections free;
  private final FreeDirections places;
  private final double t;
  private final double[] y;
  private final double[] a;
  private final int m;
  private final boolean moving;

  /** V and A_q, n × the freedoms of positions, and A_v, n × those of velocities, row by row. */
  public final double[] velocityByPlace;

  public final double[] accelerationByPlace;
  public final double[] accelerationByVelocity;

  /**
   * @param free directions of velocities
   * @param places directions of positions
   * @param y state; not modified
   * @param a accelerations that fit it; not modified
   */
  public LoopVariations(
      EquationsOfMotion equations,
      FreeDirections free,
      FreeDirections places,
      double t,
      double[] y,
      double[] a) {
    this.equations = equations;
    this.free = free;
    this.places = places;
    this.t = t;
    this.y = y;
    this.a = a;
    m = equations.lambda.length;
    velocityByPlace = new double[equations.nv * places.freedom()];
    accelerationByPlace = new double[equations.nv * places.freedom()];
    accelerationByVelocity = new double[equations.nv * free.freedom()];
    moving = m > 0 && !atRest();
    if (moving) {
      for (int j = 0; j < places.freedom(); j++) {
        varyPlace(j);
      }
      for (int j = 0; j < free.freedom(); j++) {
        double[] change = new double[equations.nv];
        free.complete(byVelocity(direction(free, j)), change);
        put(change, accelerationByVelocity, j, free.freedom());
      }
    }
  }

  /** Returns whether there are loops that move; all matrices are zero otherwise. */
  public boolean isMoving() {
    return moving;
  }

  private boolean atRest() {
    double largest = 0;
    for (int i = equations.nq; i < equations.nq + equations.nv; i++) {
      largest = Math.max(largest, Math.abs(y[i]));
    }
    for (double acceleration : a) {
      largest = Math.max(largest, Math.abs(acceleration));
    }
    for (double rate : equations.loops.rate) {
      largest = Math.max(largest, Math.abs(rate));
    }
    return largest == 0;
  }

  private double[] direction(FreeDirections of, int j) {
    double[] direction = new double[equations.nv];
    for (int i = 0; i < direction.length; i++) {
      direction[i] = of.r[i * of.freedom() + j];
    }
    return direction;
  }

  private void varyPlace(int j) {
    double[] rows = byPlace(direction(places, j));
    double[] change = new double[equations.nv];
    free.complete(Arrays.copyOf(rows, m), change);
    put(change, velocityByPlace, j, places.freedom());
    double[] accelerations = Arrays.copyOfRange(rows, m, 2 * m);
    double[] ofVelocity = byVelocity(change);
    for (int row = 0; row < m; row++) {
      accelerations[row] += ofVelocity[row];
    }
    free.complete(accelerations, change);
    put(change, accelerationByPlace, j, places.freedom());
  }

  private static void put(double[] column, double[] matrix, int j, int columns) {
    for (int i = 0; i < column.length; i++) {
      matrix[i * columns + j] = column[i];
    }
  }

  /**
   * Returns the derivatives of Φ' and Φ'' along a displacement, with constant velocities and
   * accelerations.
   */
  private double[] byPlace(double[] direction) {
    double[] coarse = difference(direction, STEP);
    double[] middle = difference(direction, STEP / 2);
    double[] fine = difference(direction, STEP / 4);
    for (int i = 0; i < fine.length; i++) {
      double first = middle[i] + (middle[i] - coarse[i]) / 3;
      double second = fine[i] + (fine[i] - middle[i]) / 3;
      fine[i] = second + (second - first) / 15;
    }
    return fine;
  }

  private double[] difference(double[] direction, double h) {
    double[] plus = displaced(direction, h);
    double[] minus = displaced(direction, -h);
    for (int i = 0; i < plus.length; i++) {
      plus[i] = (plus[i] - minus[i]) / (2 * h);
    }
    return plus;
  }

  private double[] displaced(double[] direction, double h) {
    double[] moved = y.clone();
    equations.coordinates.move(moved, 0, direction, 0, h);
    return rates(moved);
  }

  private double[] byVelocity(double[] change) {
    double[] plus = rates(faster(change, 0.5));
    double[] minus = rates(faster(change, -0.5));
    double[] difference = new double[m];
    for (int row = 0; row < m; row++) {
      difference[row] = plus[m + row] - minus[m + row];
    }
    return difference;
  }

  private double[] faster(double[] change, double factor) {
    double[] moved = y.clone();
    for (int i = 0; i < change.length; i++) {
      moved[equations.nq + i] += factor * change[i];
    }
    return moved;
  }

  /** Returns Φ' and Φ''. */
  private double[] rates(double[] state) {
    LoopEquations loops = equations.loops;
    equations.place(t, state);
    equations.motion.accelerationSweep(a);
    loops.accelerate(equations.motion, t);
    double[] both = Arrays.copyOf(loops.rate, 2 * m);
    System.arraycopy(loops.acceleration, 0, both, m, m);
    return both;
  }
}
