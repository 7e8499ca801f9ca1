package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.closure.assembly.NearestPositions;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Projects positions and velocities onto the constraint manifold by the least change in the metric
 * of the mass matrix (docs/theory/loops.md#penalty); velocities change as by an impulse along the
 * constraints. Selected coordinates may be held fixed, each by an additional equation. Workspace of
 * one thread.
 */
public final class LoopProjection {
  /** Relative residual, or rate over the speed, below which a state is not changed. */
  private static final double CLOSED = 1e-13;

  private static final int ITERATIONS = 12;

  /** Largest number of iterations after an event, which may leave positions far off the loops. */
  private static final int ITERATIONS_AFTER_JUMP = 60;

  /** Longest move of a coordinate in one iteration, rad or lengths of the mechanism. */
  private static final double LONGEST_STEP = 0.4;

  /**
   * Largest total move of a coordinate; beyond half a radian the solution may belong to another
   * assembly.
   */
  private static final double TOO_FAR = 0.5;

  /** Relative change of velocities above which they belong to another branch. */
  private static final double OTHER_BRANCH = 0.25;

  /** Speed, 1/s, below which velocities are rounding errors of a linkage that cannot move. */
  private static final double SLOWEST = 1e-9;

  private final ClosedTree work;

  /** Rounding errors of the residuals at the projected positions. */
  public final LoopRounding rounding;

  private final PenaltyEquations equations;

  /** Velocities that must not change; empty if none can be held. */
  private final boolean[] held;

  /** Finds positions after jumps that leave Newton's method without a way. */
  private Optional<NearestPositions> nearest = Optional.empty();

  private final double[] none;
  private final double[] offset;
  private final double[] change;

  public LoopProjection(ClosedTree work, PenaltySettings settings) {
    this(work, settings, false);
  }

  /** Returns a projection that can hold coordinates fixed. */
  public static LoopProjection holding(ClosedTree work) {
    return new LoopProjection(work, PenaltySettings.DEFAULT, true);
  }

  private LoopProjection(ClosedTree work, PenaltySettings settings, boolean holds) {
    this.work = work;
    rounding = new LoopRounding(work.tree, work.loops, work.coordinates);
    held = new boolean[holds ? work.nv : 0];
    equations =
        work.isLarge()
            ? new RecursivePenalty(work, settings.stiffness(), holds)
            : new DensePenalty(work, settings.stiffness(), holds);
    none = new double[work.nv];
    offset = new double[work.loops.count()];
    change = new double[work.nv];
  }

  /** Returns the equations last factored; accelerations may be solved with them too. */
  public PenaltyEquations equations() {
    return equations;
  }

  /**
   * Factors at the placed state; returns a negative number, or the index of the velocity without
   * inertia.
   */
  public int factor() {
    return equations.factor(held);
  }

  /** Projects positions, then velocities; returns whether both satisfy the constraints. */
  public boolean project(double t, double[] y) {
    return projectPositions(t, y) && projectVelocities(t, y, OTHER_BRANCH);
  }

  /**
   * Likewise, far from singular positions: only there are several velocities possible at the same
   * positions, and a drive that begins after a rest changes velocities by all of their size.
   */
  public boolean projectFarFromSingular(double t, double[] y) {
    return projectPositions(t, y) && projectVelocities(t, y, Double.POSITIVE_INFINITY);
  }

  /**
   * Closes the loops after a jump: first with some velocities and their positions held fixed, then,
   * if a residual remains, with all free. Where Newton's method finds no way, as at half a turn,
   * the positions are found as at a start.
   *
   * @param positionSet velocities whose positions are held
   * @param velocitySet velocities that are held
   * @return whether the state satisfies the constraints
   */
  public boolean jump(double t, double[] y, boolean[] positionSet, boolean[] velocitySet) {
    System.arraycopy(positionSet, 0, held, 0, held.length);
    double[] given = y.clone();
    if (!closePositions(t, y) && closeFromFar(t, given, positionSet)) {
      System.arraycopy(given, 0, y, 0, y.length);
    }
    System.arraycopy(velocitySet, 0, held, 0, held.length);
    projectVelocities(t, y, Double.POSITIVE_INFINITY);
    Arrays.fill(held, false);
    return closePositions(t, y) && projectVelocities(t, y, Double.POSITIVE_INFINITY);
  }

  /**
   * Closes the loops as at a start, by the nearest positions, with those held that were set.
   *
   * @return whether it could; if not, the state is unchanged
   */
  private boolean closeFromFar(double t, double[] y, boolean[] positionSet) {
    ClosedTree data = work.ofData();
    if (nearest.isEmpty()) {
      nearest =
          Optional.of(
              new NearestPositions(
                  data.motion, data.loops, data.coordinates, data.units, rounding));
    }
    double[] willing = new double[work.nv];
    Arrays.setAll(willing, j -> positionSet[j] ? 0 : 1);
    double[] closed = y.clone();
    boolean closes = nearest.get().closeInTurn(t, closed, willing);
    if (closes) {
      System.arraycopy(closed, 0, y, 0, y.length);
    }
    return closes;
  }

  /** Newton's method in steps of limited length. */
  private boolean closePositions(double t, double[] y) {
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i < ITERATIONS_AFTER_JUMP; i++) {
      work.place(t, y);
      double residual = rounding.excess(y);
      if (isClosed(residual, before)) {
        return true;
      }
      if (factor() >= 0) {
        return false;
      }
      before = residual;
      solvePositions(y);
      double largest = largestChange();
      if (!Double.isFinite(largest)) {
        return false;
      }
      work.coordinates.move(y, 0, change, 0, Math.min(1, LONGEST_STEP / largest));
    }
    return false;
  }

  private boolean projectPositions(double t, double[] y) {
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i < ITERATIONS; i++) {
      work.place(t, y);
      double residual = rounding.excess(y);
      if (isClosed(residual, before)) {
        return true;
      }
      if (!(residual < before) || factor() >= 0) {
        return false;
      }
      before = residual;
      solvePositions(y);
      if (!(largestChange() <= TOO_FAR)) {
        return false;
      }
      work.coordinates.move(y, 0, change, 0, 1);
    }
    return false;
  }

  /**
   * Returns whether a residual is small, or whether the last iteration hardly reduced it: then it
   * is a misfit of redundant equations.
   */
  private static boolean isClosed(double residual, double before) {
    return residual <= CLOSED || (residual <= LoopRounding.MISFIT && residual > 0.5 * before);
  }

  private void solvePositions(double[] y) {
    for (int row = 0; row < work.loops.count(); row++) {
      double residual = work.loops.value[row] / work.loops.size(row);
      offset[row] = LoopRounding.beyond(rounding.leftAlone(row, y), residual);
    }
    equations.solve(none, offset, change, 0);
  }

  /**
   * Changes velocities as an impulse along the constraints does.
   *
   * @param allowed largest permitted relative change of the velocities
   * @return whether they satisfy the constraints
   */
  boolean projectVelocities(double t, double[] y, double allowed) {
    work.place(t, y);
    double speed = Math.max(SLOWEST, work.units.speed(y, work.nq));
    if (!(rate(y, speed) > CLOSED * speed)) {
      return Double.isFinite(speed);
    }
    if (factor() >= 0) {
      return false;
    }
    equations.solve(none, offset, change, 0);
    if (!(largestChange() <= allowed * speed)) {
      return false;
    }
    for (int j = 0; j < work.nv; j++) {
      y[work.nq + j] += change[j];
    }
    return true;
  }

  /**
   * Removes from a change of the state the part of its velocities that changes the rates of the
   * constraints.
   *
   * @param y state; not modified
   * @param x change of the state; its velocities are overwritten
   * @return false if the mass matrix is singular
   */
  public boolean projectChange(double t, double[] y, double[] x) {
    work.place(t, y);
    if (factor() >= 0) {
      return false;
    }
    for (int row = 0; row < work.loops.count(); row++) {
      offset[row] = rateOfChange(row, x) / work.loops.size(row);
    }
    equations.solve(none, offset, change, 0);
    for (int j = 0; j < work.nv; j++) {
      x[work.nq + j] += change[j];
    }
    return true;
  }

  /** Returns a row of J times the velocities of a change; driven joints are not among them. */
  private double rateOfChange(int row, double[] x) {
    SparseMatrix j = work.loops.jacobian;
    double sum = 0;
    for (int e = j.start[row]; e < j.start[row + 1]; e++) {
      if (j.column[e] < work.nv) {
        sum += j.value[e] * x[work.nq + j.column[e]];
      }
    }
    return sum;
  }

  /** Computes the rates to be removed; returns the largest, 1/s. */
  private double rate(double[] y, double speed) {
    double largest = 0;
    for (int row = 0; row < work.loops.count(); row++) {
      double rate = work.loops.rate[row] / work.loops.size(row);
      offset[row] = LoopRounding.beyond(rounding.leftAlone(row, y) * speed, rate);
      largest = larger(Math.abs(offset[row]), largest);
    }
    return largest;
  }

  /** Returns the larger of two, the first if it is NaN. */
  private static double larger(double part, double largest) {
    return part > largest || Double.isNaN(part) ? part : largest;
  }

  private double largestChange() {
    double largest = 0;
    for (int j = 0; j < work.nv; j++) {
      largest = larger(Math.abs(change[j]) / work.units.velocities[j], largest);
    }
    return largest;
  }
}
