package org.mechservice.solver.closure.equations;

import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Estimated rounding errors of the loops' residuals. Far from the origin, or after many turns,
 * coordinates and fixed points carry rounding errors that are large relative to the mechanism. To
 * first order a residual's error is Σ |∂Φ/∂q_j| ulp(q_j), plus the unit in the last place of the
 * farthest fixed point's coordinates. Workspace of one thread.
 *
 * <p>A correction of a state does not remove all of a residual's rounding error ({@link
 * #leftAlone}). Corrections by rounding errors would make successive states rough and would
 * dominate the high-order differences from which error tests are made.
 */
public final class LoopRounding {
  /** Relative residual, beyond rounding, that is accepted. */
  public static final double CLOSED = 1e-11;

  /**
   * Relative residual, beyond rounding, that is accepted where no motion reduces it: the misfit of
   * data that are given with finitely many digits, in an equation that follows from the others. It
   * equals the fraction of the largest singular value below which an equation counts as dependent.
   * Were it larger, an equation could be left open that counts as independent; were it smaller, one
   * could be refused that nothing distinguishes from a dependent one. The tolerances of the
   * integration do not enter: a misfit is an error of the data, and the same in all runs.
   */
  public static final double MISFIT = 1e-8;

  /** Number of rounding errors per coordinate and fixed point: about four operations. */
  private static final double ROUNDINGS = 4;

  /**
   * Fraction of the rounding error that corrections do not remove; the rest can still be
   * distinguished from rounding.
   */
  private static final double LEFT_ALONE = 0.5;

  /** A rotation is twice the vector part of a change of Euler parameters, which are at most 1. */
  private static final double OF_ROTATION = 2 * Math.ulp(1.0);

  /** Rounding error of (|e|² − 1)/2: half an ulp of each of four squares, and of their sums. */
  public static final double OF_NORM = ROUNDINGS * Math.ulp(1.0);

  private final LoopEquations loops;
  private final StateCoordinates coordinates;

  /**
   * Unit in the last place of the farthest fixed point's coordinates, relative to the mechanism's
   * length.
   */
  private final double ofPlaces;

  /**
   * Rounding errors of the way to the points of each equation, relative to its size: every link on
   * it adds the unit in the last place of the length reached, and they are as often positive as
   * negative. A chain of 2560 links carries 2e-11 of a link.
   */
  private final double[] ofWay;

  public LoopRounding(TreeGeometry tree, LoopEquations loops, StateCoordinates coordinates) {
    this.loops = loops;
    this.coordinates = coordinates;
    ofPlaces = Math.ulp(LengthScale.farthest(tree)) / loops.length();
    ofWay = new double[loops.count()];
    for (int row = 0; row < ofWay.length; row++) {
      int[] ways = loops.support(row).ways();
      double reach = loops.isLength(row) ? 1 + LengthScale.reach(tree, ways) / loops.length() : 1;
      ofWay[row] = Math.ulp(reach) * Math.sqrt(ways.length);
    }
  }

  /**
   * Returns the relative rounding error of an equation's residual at or near the positions at which
   * J was formed. Multiplied by the speed it is the rounding error of the rate.
   *
   * @param y state that begins with the positions; not modified
   */
  double part(int row, double[] y) {
    SparseMatrix jacobian = loops.jacobian;
    int end = jacobian.start[row];
    double sum = 0;
    for (; end < jacobian.start[row + 1] && isOfState(jacobian.column[end]); end++) {
      int position = coordinates.positionOf(jacobian.column[end]);
      if (position >= 0) {
        sum += Math.abs(jacobian.value[end]) * Math.ulp(y[position]);
      }
    }
    for (int e = jacobian.start[row]; e < end && coordinates.ballCount() > 0; e++) {
      if (coordinates.positionOf(jacobian.column[e]) < 0) {
        sum += Math.abs(jacobian.value[e]) * OF_ROTATION;
      }
    }
    return ROUNDINGS * (sum / loops.size(row) + ofPlace(row));
  }

  /** Returns the rounding error of fixed places in an equation, relative to its size. */
  public double ofPlace(int row) {
    return loops.isLength(row) ? ofPlaces : 0;
  }

  private boolean isOfState(int velocity) {
    return velocity < coordinates.velocityCount();
  }

  /**
   * Returns the relative rounding error of an equation's residual, with that of the way to its
   * points, which no correction sees.
   *
   * @param y state that begins with the positions; not modified
   */
  public double of(int row, double[] y) {
    return part(row, y) + ROUNDINGS * ofWay[row];
  }

  /**
   * Returns the excess of an equation's last residual over its rounding error, relative to its
   * size.
   */
  public double excess(int row, double[] y) {
    return Math.abs(loops.value[row]) / loops.size(row) - of(row, y);
  }

  /** Returns the largest {@link #excess} of all equations, NaN if one is. */
  public double excess(double[] y) {
    double largest = 0;
    for (int row = 0; row < loops.count(); row++) {
      double excess = excess(row, y);
      if (excess > largest || Double.isNaN(excess)) {
        largest = excess;
      }
    }
    return largest;
  }

  /** Returns the part of a relative residual that corrections do not remove. */
  public double leftAlone(int row, double[] y) {
    return LEFT_ALONE * part(row, y);
  }

  /** Returns the part of a residual that a correction removes. */
  public static double beyond(double leftAlone, double residual) {
    double beyond = Math.abs(residual) - leftAlone;
    return beyond <= 0 ? 0 : Math.copySign(beyond, residual);
  }
}
