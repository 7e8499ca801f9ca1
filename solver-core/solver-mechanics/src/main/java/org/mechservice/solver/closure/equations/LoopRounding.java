package org.mechservice.solver.closure.equations;

import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * How large residuals of the loops are by rounding alone: coordinates and fixed points are rounded,
 * far from the origin, or after many turns, to more than a part of the mechanism's size. To first
 * order a residual then differs by Σ |∂Φ/∂q_j| ulp(q_j), and by the spacing of numbers as large as
 * the farthest fixed point, which places are computed from. Workspace of one thread.
 *
 * <p>Who corrects a state by a residual leaves a part of its rounding alone ({@link #leftAlone}):
 * the state then stays as smooth as its steps, where corrections by rounding errors would make it
 * rough, and differences of high order, which error tests are made of, would see nothing else.
 */
public final class LoopRounding {
  /** Residual over its size that will do, rounding left out. */
  public static final double CLOSED = 1e-11;

  /** Rounding errors that add up with each coordinate and fixed point: four operations or so. */
  private static final double ROUNDINGS = 4;

  /** Part of that which no correction touches: what remains can still be told from rounding. */
  private static final double LEFT_ALONE = 0.5;

  /** A rotation is twice the vector part of a change of Euler parameters, which are at most 1. */
  private static final double OF_ROTATION = 2 * Math.ulp(1.0);

  private final LoopEquations loops;
  private final StateCoordinates coordinates;

  /** Spacing of the farthest fixed point's coordinates over the length of the mechanism. */
  private final double ofPlaces;

  public LoopRounding(TreeGeometry tree, LoopEquations loops, StateCoordinates coordinates) {
    this.loops = loops;
    this.coordinates = coordinates;
    ofPlaces = Math.ulp(LengthScale.farthest(tree)) / loops.length();
  }

  /**
   * Returns the residual by rounding of an equation, over its size, where J was formed at positions
   * or near by. Times the speed it is that of its rate.
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
    return ROUNDINGS * (sum / loops.size(row) + (loops.unit(row).equals("rad") ? 0 : ofPlaces));
  }

  private boolean isOfState(int velocity) {
    return velocity < coordinates.velocityCount();
  }

  /** Returns how far an equation's residual last placed lies above its rounding, over its size. */
  public double excess(int row, double[] y) {
    return Math.abs(loops.value[row]) / loops.size(row) - part(row, y);
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

  /** Returns the part of a residual over its size that corrections leave alone. */
  public double leftAlone(int row, double[] y) {
    return LEFT_ALONE * part(row, y);
  }

  /** Returns how far a residual is from zero beyond what is left alone. */
  public static double beyond(double leftAlone, double residual) {
    double beyond = Math.abs(residual) - leftAlone;
    return beyond <= 0 ? 0 : Math.copySign(beyond, residual);
  }
}
