package org.mechservice.solver.closure.assembly;

import java.util.Arrays;
import java.util.Random;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.Interruption;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The positions nearest to given ones that close the loops: the least Σ (δ_j / (u_j w_j))² with
 * Φ(q) = 0, δ being the move along the tangent, u_j the unit of a coordinate and w_j how willingly
 * it moves (docs/theory/loops.md#assembly). Workspace of one thread; allocates.
 *
 * <p>An attempt closes the loops by damped Gauss-Newton steps from a state, and then descends along
 * the closed positions towards the given ones: steps within a trusted distance by conjugate
 * gradients in the null space of J (Steihaug 1983; Gould, Hribar and Nocedal 2001), each followed
 * by closing again. If the positions found are within twice the first Gauss-Newton step η, and h of
 * Newton and Kantorovich is at most one half, they are the only ones as near. h is β K η with the
 * inverse β of the smallest singular value of J; the second derivatives K of n coordinates are at
 * most √n times the largest singular value, since both consist of the same levers. The residual
 * that the step leaves, h/2 of the first along it, must agree; for large mechanisms it decides
 * alone. Otherwise attempts from random states around the given one, as far from it as the best
 * found, look for nearer ones.
 */
public final class NearestPositions {
  /**
   * Willingness of a coordinate with a given value to move; that of a free one is 1. The squares of
   * moves over it are least, so a given value moves by a millionth more than it must, if a free one
   * then moves less.
   */
  public static final double RELUCTANT = 1e-3;

  /** Relative residual beyond rounding below which the loops are closed. */
  static final double CLOSED = 1e-13;

  private static final int ITERATIONS = 60;

  /** Longest move of a coordinate in one iteration, rad or lengths of the mechanism. */
  private static final double LONGEST_STEP = 0.4;

  /** Part of the residual that the first step of an attempt without rivals leaves at most, h/2. */
  private static final double WITHOUT_RIVALS = 0.25;

  /**
   * Sizes of random moves of the given positions while nothing closes the loops, rad or lengths.
   */
  private static final double[] KICKS = {0.01, 0.1, 0.3, 0.6, 1.5, Math.PI};

  /** Number of attempts after the first, for small and for large mechanisms. */
  private static final int ATTEMPTS = 36;

  private static final int ATTEMPTS_IF_LARGE = 4;

  /** Relative difference of distances below which they are equal. */
  private static final double AS_NEAR = 1e-6;

  private static final int DESCENTS = 60;

  /**
   * Part of the gradient of the distance along the closed positions at which they are the nearest:
   * the distance is then within its square of the least.
   */
  private static final double NEAREST = 1e-8;

  /** Relative change of positions for differences of gradients: the root of the rounding errors. */
  private static final double DIFFERENCE = 1e-7;

  private final TreeMotion motion;
  private final LoopEquations loops;
  private final StateCoordinates coordinates;
  private final LoopRounding rounding;
  private final CoordinateUnits units;
  private final LeastMoves least;
  private final SparseMatrix matrix;
  private final int nv;
  private final double[] right;
  private final double[] ofRows;
  private final double[] step;
  private final double[] moved;

  /** What a unit of each coordinate is in an iteration that closes the loops: 0 if it is held. */
  private final double[] unit;

  /** What a unit of each coordinate is in the distance. */
  private final double[] metric;

  private double[] given = new double[0];
  private double time;

  /**
   * Distance within which the last iteration has no other solution, in units; 0 if it proved
   * nothing.
   */
  private double withoutRivals;

  /**
   * Prepares the search with the workspace of others, which is overwritten.
   *
   * @param rounding of the loops
   */
  public NearestPositions(
      TreeMotion motion,
      LoopEquations loops,
      StateCoordinates coordinates,
      CoordinateUnits units,
      LoopRounding rounding) {
    this(
        motion,
        loops,
        coordinates,
        units,
        rounding,
        LeastMoves.of(loops, coordinates.velocityCount(), loops.isLargeToSetUp()));
  }

  NearestPositions(
      TreeMotion motion,
      LoopEquations loops,
      StateCoordinates coordinates,
      CoordinateUnits units,
      LoopRounding rounding,
      LeastMoves least) {
    this.motion = motion;
    this.loops = loops;
    this.coordinates = coordinates;
    this.units = units;
    this.rounding = rounding;
    this.least = least;
    matrix = loops.jacobian.sameShape();
    nv = coordinates.velocityCount();
    right = new double[loops.count()];
    ofRows = new double[loops.count()];
    step = new double[nv];
    moved = new double[nv];
    unit = new double[nv];
    metric = new double[nv];
  }

  /** A state with its largest relative residual beyond rounding, and its distance. */
  private static final class Attempt {
    private final double[] y;
    private final double residual;
    private final double distance;

    Attempt(double[] y, double residual, double distance) {
      this.y = y;
      this.residual = residual;
      this.distance = distance;
    }

    boolean closes() {
      return residual <= LoopRounding.MISFIT;
    }

    boolean isBetterThan(Attempt other) {
      if (!closes() || !other.closes() || (residual <= CLOSED) != (other.residual <= CLOSED)) {
        return residual < other.residual;
      }
      return distance < (1 - AS_NEAR) * other.distance;
    }
  }

  /**
   * Finds the positions: by free coordinates alone if they suffice, otherwise by reluctant ones
   * too, which move as little as possible. What moves reduce by less than half is a misfit of the
   * data, for which nothing is moved.
   *
   * @param t s
   * @param y state with the given positions; overwritten by the nearest that close the loops, or by
   *     those with the least residual that was found
   * @param willing 1 for a free coordinate, {@link #RELUCTANT} or 0 if it must not move
   * @return whether the loops are closed
   */
  public boolean closeInTurn(double t, double[] y, double[] willing) {
    double open = place(t, y);
    double[] byFree = y.clone();
    double[] free = new double[nv];
    boolean reluctant = false;
    for (int j = 0; j < nv; j++) {
      free[j] = willing[j] == 1 ? 1 : 0;
      reluctant |= willing[j] == RELUCTANT;
    }
    double leftByFree = find(t, byFree, free);
    double left = leftByFree;
    double[] closed = byFree;
    if (!(leftByFree <= CLOSED) && reluctant) {
      double[] byAll = y.clone();
      double leftByAll = find(t, byAll, willing);
      if (leftByAll < 0.5 * leftByFree || !(leftByFree <= LoopRounding.MISFIT)) {
        left = leftByAll;
        closed = byAll;
      }
    }
    if (left < 0.5 * open || !(open <= LoopRounding.MISFIT)) {
      System.arraycopy(closed, 0, y, 0, y.length);
    }
    return left <= LoopRounding.MISFIT;
  }

  /**
   * Finds the positions by all coordinates that may move.
   *
   * @param t s
   * @param y state with the given positions; overwritten by the nearest that close the loops, or by
   *     those with the least residual that was found
   * @param willing w, one number per velocity, at most 1; 0 if it must not move
   * @return the largest relative residual beyond rounding
   */
  double find(double t, double[] y, double[] willing) {
    begin(t, y, willing);
    Attempt best = attempt(y);
    if (!best.closes() || lengthTo(best.y) > withoutRivals) {
      Random random = new Random(271828);
      int attempts = loops.isLargeToSetUp() ? ATTEMPTS_IF_LARGE : ATTEMPTS;
      for (int i = 0; i < attempts; i++) {
        double size = best.closes() ? farthest(best.y) : KICKS[i % KICKS.length];
        Attempt next = attempt(kicked(random, Math.min(size, Math.PI)));
        best = next.isBetterThan(best) ? next : best;
      }
    }
    System.arraycopy(best.y, 0, y, 0, y.length);
    return best.residual;
  }

  /**
   * Closes the loops by the first positions found, all coordinates being free.
   *
   * @param t s
   * @param y state; overwritten
   * @return the largest relative residual beyond rounding
   */
  double close(double t, double[] y) {
    double[] willing = new double[nv];
    Arrays.fill(willing, 1);
    begin(t, y, willing);
    return iterate(y);
  }

  private void begin(double t, double[] y, double[] willing) {
    time = t;
    given = y.clone();
    for (int j = 0; j < nv; j++) {
      unit[j] = willing[j] > 0 ? units.velocities[j] : 0;
      metric[j] = willing[j] * units.velocities[j];
    }
  }

  /** Evaluates Φ and J; returns the largest relative residual beyond rounding. */
  double place(double t, double[] y) {
    motion.sweep(t, y);
    loops.placeFar(motion, t);
    loops.differentiate(motion);
    return rounding.excess(y);
  }

  private Attempt attempt(double[] from) {
    double[] y = from.clone();
    double residual = iterate(y);
    double alone = withoutRivals;
    if (residual <= LoopRounding.MISFIT) {
      residual = descend(y, residual);
    }
    withoutRivals = alone;
    return new Attempt(y, residual, Double.isNaN(residual) ? residual : distance(y));
  }

  private double[] kicked(Random random, double size) {
    double[] y = given.clone();
    for (int j = 0; j < nv; j++) {
      moved[j] = (2 * random.nextDouble() - 1) * unit[j];
    }
    coordinates.move(y, 0, moved, 0, size);
    return y;
  }

  /** Returns the largest move of a coordinate from the given positions, rad or lengths. */
  private double farthest(double[] y) {
    coordinates.moveBetween(given, y, moved);
    double farthest = 0;
    for (int j = 0; j < nv; j++) {
      farthest = Math.max(farthest, unit[j] > 0 ? Math.abs(moved[j]) / unit[j] : 0);
    }
    return farthest;
  }

  /** Returns the distance from the given positions with all units equal. */
  private double lengthTo(double[] y) {
    coordinates.moveBetween(given, y, moved);
    for (int j = 0; j < nv; j++) {
      moved[j] = unit[j] > 0 ? moved[j] / unit[j] : 0;
    }
    return Math.sqrt(dot(moved, moved));
  }

  /** Writes the moves from the given positions in units of the metric. */
  private void displacement(double[] y, double[] d) {
    coordinates.moveBetween(given, y, d);
    for (int j = 0; j < nv; j++) {
      d[j] = metric[j] > 0 ? d[j] / metric[j] : 0;
    }
  }

  private double distance(double[] y) {
    displacement(y, moved);
    return Math.sqrt(dot(moved, moved));
  }

  /** Closes the loops by damped Gauss-Newton steps; returns the residual reached. */
  private double iterate(double[] y) {
    double merit = merit(y);
    double first = merit;
    double damping = 0;
    withoutRivals = rounding.excess(y) <= LoopRounding.MISFIT ? Double.POSITIVE_INFINITY : 0;
    for (int i = 0; i < ITERATIONS && rounding.excess(y) > CLOSED; i++) {
      Interruption.check();
      take(unit);
      double[] tried = y.clone();
      least.solve(damping, right, step);
      boolean whole = advance(tried);
      double reached = merit(tried);
      if (i == 0 && whole && reached <= WITHOUT_RIVALS * WITHOUT_RIVALS * first) {
        double length = Math.sqrt(dot(step, step));
        double most = 2 * WITHOUT_RIVALS / (Math.sqrt(nv) * length);
        boolean proved = least.largestOverSmallest().stream().allMatch(ratio -> ratio <= most);
        withoutRivals = proved ? Math.max(withoutRivals, 2 * length) : withoutRivals;
      }
      if (reached < merit) {
        boolean slow = reached > 0.5 * merit;
        merit = reached;
        damping = slow ? damping : damping / 10;
        damping = damping < 1e-14 ? 0 : damping;
        System.arraycopy(tried, 0, y, 0, y.length);
      } else {
        damping = Math.max(10 * damping, 1e-8);
        if (damping > 1e3) {
          break;
        }
        merit(y);
      }
    }
    return place(time, y);
  }

  /** Evaluates Φ and J at a state, and the sum of the squares of relative residuals. */
  private double merit(double[] y) {
    place(time, y);
    double sum = 0;
    for (int row = 0; row < loops.count(); row++) {
      double part = loops.value[row] / loops.size(row);
      right[row] = -part;
      sum += part * part;
    }
    return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum;
  }

  /** Takes J with rows divided by their sizes and columns in units, which must not be zero. */
  private void take(double[] unit) {
    for (int row = 0; row < loops.count(); row++) {
      for (int e = matrix.start[row]; e < matrix.start[row + 1]; e++) {
        int j = matrix.column[e];
        boolean counts = j < nv && loops.isHolonomic(row);
        matrix.value[e] = counts ? loops.jacobian.value[e] * unit[j] / loops.size(row) : 0;
      }
    }
    least.take(matrix);
  }

  /** Moves a state by the step; returns whether by the whole of it. */
  private boolean advance(double[] y) {
    double longest = 0;
    for (int j = 0; j < nv; j++) {
      longest = Math.max(longest, unit[j] > 0 ? Math.abs(step[j]) : 0);
      moved[j] = step[j] * unit[j];
    }
    coordinates.move(y, 0, moved, 0, longest > LONGEST_STEP ? LONGEST_STEP / longest : 1);
    return longest <= LONGEST_STEP;
  }

  /**
   * Descends along the closed positions to the nearest ones.
   *
   * @param y state that closes the loops; overwritten
   * @param residual at it
   * @return the residual reached
   */
  private double descend(double[] y, double residual) {
    double[] d = new double[nv];
    double[] s = new double[nv];
    double[] lambda = new double[loops.count()];
    displacement(y, d);
    double distance = Math.sqrt(dot(d, d));
    double trust = distance;
    double reached = residual;
    for (int i = 0; i < DESCENTS && trust > NEAREST * distance; i++) {
      Interruption.check();
      place(time, y);
      take(metric);
      double[] downhill = projected(d, -1);
      if (!(Math.sqrt(dot(downhill, downhill)) > NEAREST * distance)) {
        break;
      }
      for (int j = 0; j < nv; j++) {
        step[j] = -d[j];
      }
      least.solveTransposed(step, lambda);
      double expected = new Lagrangian(y, lambda).step(downhill, trust, s);
      double[] tried = y.clone();
      for (int j = 0; j < nv; j++) {
        moved[j] = s[j] * metric[j];
      }
      coordinates.move(tried, 0, moved, 0, 1);
      double open = iterate(tried);
      boolean closes = open <= Math.max(CLOSED, Math.min(2 * residual, LoopRounding.MISFIT));
      double next = closes ? distance(tried) : Double.POSITIVE_INFINITY;
      double gain = 0.5 * (distance - next) * (distance + next);
      if (gain > 0) {
        System.arraycopy(tried, 0, y, 0, y.length);
        reached = open;
        distance = next;
        displacement(y, d);
      }
      double length = Math.sqrt(dot(s, s));
      trust =
          gain < 0.25 * expected
              ? 0.25 * length
              : gain > 0.75 * expected ? Math.max(trust, 2 * length) : trust;
    }
    return reached;
  }

  /** Returns the part of a vector, times a factor, that does not change Φ to first order. */
  private double[] projected(double[] x, double factor) {
    double[] result = new double[nv];
    for (int j = 0; j < nv; j++) {
      result[j] = metric[j] > 0 ? factor * x[j] : 0;
    }
    for (int row = 0; row < loops.count(); row++) {
      ofRows[row] = 0;
      for (int e = matrix.start[row]; e < matrix.start[row + 1]; e++) {
        int j = matrix.column[e];
        ofRows[row] += j < nv ? matrix.value[e] * result[j] : 0;
      }
    }
    least.solve(0, ofRows, step);
    for (int j = 0; j < nv; j++) {
      result[j] -= metric[j] > 0 ? step[j] : 0;
    }
    return result;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /**
   * ½ |d|² + λᵀ Φ with its second derivatives, 1 + λᵀ ∂²Φ, along the closed positions; those of Φ
   * by differences of J.
   */
  private final class Lagrangian {
    private static final int MOST = 40;

    private final double[] y;
    private final double[] lambda;
    private final double[] gradient;

    /** Needs the matrix of the metric at y. */
    Lagrangian(double[] y, double[] lambda) {
      this.y = y;
      this.lambda = lambda;
      gradient = gradient(0, new double[nv]);
    }

    /** Returns λᵀ J in the metric after a move. */
    private double[] gradient(double size, double[] direction) {
      double[] at = y.clone();
      for (int j = 0; j < nv; j++) {
        moved[j] = direction[j] * metric[j];
      }
      coordinates.move(at, 0, moved, 0, size);
      place(time, at);
      double[] sum = new double[nv];
      SparseMatrix jacobian = loops.jacobian;
      for (int row = 0; row < loops.count(); row++) {
        for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
          int j = jacobian.column[e];
          if (j < nv && loops.isHolonomic(row)) {
            sum[j] += lambda[row] * jacobian.value[e] * metric[j] / loops.size(row);
          }
        }
      }
      return sum;
    }

    /** Returns the second derivatives times a vector. */
    private double[] times(double[] v) {
      double largest = 0;
      for (int j = 0; j < nv; j++) {
        largest = Math.max(largest, Math.abs(v[j]) * metric[j] / units.velocities[j]);
      }
      double size = DIFFERENCE / largest;
      double[] changed = gradient(size, v);
      for (int j = 0; j < nv; j++) {
        changed[j] = v[j] + (changed[j] - gradient[j]) / size;
      }
      return projected(changed, 1);
    }

    /**
     * Finds a step that reduces the quadratic form.
     *
     * @param downhill the reversed gradient, projected; not modified
     * @param trust longest step
     * @param s overwritten
     * @return by how much the form falls
     */
    double step(double[] downhill, double trust, double[] s) {
      Arrays.fill(s, 0);
      double[] rest = downhill.clone();
      double[] direction = downhill.clone();
      double square = dot(rest, rest);
      double enough = NEAREST * square;
      double fallen = 0;
      for (int i = 0; i < MOST && square > enough; i++) {
        double[] image = times(direction);
        double bend = dot(direction, image);
        double whole = bend > 0 ? square / bend : Double.POSITIVE_INFINITY;
        double most = toBoundary(s, direction, trust);
        double size = Math.min(whole, most);
        double along = dot(rest, direction);
        fallen += size * along - 0.5 * size * size * bend;
        for (int j = 0; j < nv; j++) {
          s[j] += size * direction[j];
          rest[j] -= size * image[j];
        }
        if (whole >= most) {
          break;
        }
        double before = square;
        square = dot(rest, rest);
        for (int j = 0; j < nv; j++) {
          direction[j] = rest[j] + square / before * direction[j];
        }
      }
      return fallen;
    }

    /** Returns the largest x with |s + x direction| = trust. */
    private double toBoundary(double[] s, double[] direction, double trust) {
      double a = dot(direction, direction);
      double b = dot(s, direction);
      double c = dot(s, s) - trust * trust;
      return (-b + Math.sqrt(Math.max(0, b * b - a * c))) / a;
    }
  }
}
