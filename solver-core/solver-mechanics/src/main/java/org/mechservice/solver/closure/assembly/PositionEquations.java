package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The equations of the positions of the state: Φ(q, t) = 0, without non-holonomic equations, and,
 * for each set of Euler parameters, (|e|² − 1)/2 = 0, with their derivatives by q. Workspace of one
 * thread.
 */
public final class PositionEquations {
  private final LoopEquations loops;
  private final StateCoordinates coordinates;

  /** The loop equations that restrict positions. */
  private final int[] loopRow;

  /** Number of equations, that of Φ first. */
  public final int count;

  /** Number of positions. */
  final int unknowns;

  /** Left sides. */
  public final double[] value;

  /** ∂/∂q. */
  public final SparseMatrix matrix;

  /** Indices of the elements of Euler parameters, by set and equation. */
  private final List<BallElements> balls = new ArrayList<>();

  /**
   * The four elements of a set of Euler parameters in an equation, and the three of its angular
   * velocity in J.
   */
  private record BallElements(int ball, int element, int ofVelocity) {}

  /** For each element of the matrix the index of the equal element of J, or -1. */
  private final int[] ofVelocity;

  public PositionEquations(LoopEquations loops, StateCoordinates coordinates) {
    this.loops = loops;
    this.coordinates = coordinates;
    loopRow = IntStream.range(0, loops.count()).filter(loops::isHolonomic).toArray();
    count = loopRow.length + coordinates.ballCount();
    unknowns = coordinates.positionCount();
    value = new double[count];
    matrix = SparseMatrix.of(pattern(), unknowns);
    ofVelocity = new int[matrix.column.length];
    Arrays.fill(ofVelocity, -1);
    for (int row = 0; row < loopRow.length; row++) {
      findElements(row);
    }
  }

  private int[][] pattern() {
    int[] ballOf = new int[coordinates.velocityCount()];
    Arrays.fill(ballOf, -1);
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int at = coordinates.ballVelocity(ball);
      Arrays.fill(ballOf, at, at + 3, ball);
    }
    int[][] pattern = new int[count][];
    for (int row = 0; row < loopRow.length; row++) {
      BitSet columns = new BitSet();
      for (int e = loops.jacobian.start[loopRow[row]]; e < endOfState(loopRow[row]); e++) {
        int velocity = loops.jacobian.column[e];
        if (ballOf[velocity] < 0) {
          columns.set(coordinates.positionOf(velocity));
        } else {
          int at = coordinates.ballPosition(ballOf[velocity]);
          columns.set(at, at + 4);
        }
      }
      pattern[row] = columns.stream().toArray();
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int at = coordinates.ballPosition(ball);
      pattern[loopRow.length + ball] = new int[] {at, at + 1, at + 2, at + 3};
    }
    return pattern;
  }

  private int endOfState(int row) {
    int end = loops.jacobian.start[row + 1];
    while (end > loops.jacobian.start[row]
        && loops.jacobian.column[end - 1] >= coordinates.velocityCount()) {
      end--;
    }
    return end;
  }

  private void findElements(int row) {
    int[] jacobianColumn = loops.jacobian.column;
    int from = loops.jacobian.start[loopRow[row]];
    int end = endOfState(loopRow[row]);
    for (int e = from; e < end; e++) {
      int position = coordinates.positionOf(jacobianColumn[e]);
      if (position >= 0) {
        ofVelocity[element(row, position)] = e;
      }
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int e = Arrays.binarySearch(jacobianColumn, from, end, coordinates.ballVelocity(ball));
      if (e >= 0) {
        balls.add(new BallElements(ball, element(row, coordinates.ballPosition(ball)), e));
      }
    }
  }

  private int element(int row, int position) {
    return Arrays.binarySearch(matrix.column, matrix.start[row], matrix.start[row + 1], position);
  }

  /** Returns the size of what an equation measures: m, or 1 of rotations and norms. */
  public double size(int row) {
    return row < loopRow.length ? loops.size(loopRow[row]) : 1;
  }

  /**
   * Returns the rounding error of an equation's value, in its unit; the equations must be placed.
   *
   * @param q positions; not modified
   */
  public double rounding(int row, LoopRounding rounding, double[] q) {
    return row < loopRow.length
        ? rounding.of(loopRow[row], q) * loops.size(loopRow[row])
        : LoopRounding.OF_NORM;
  }

  /** Evaluates Φ and the norms; the equations must be placed. */
  public void evaluate(double[] q) {
    for (int row = 0; row < loopRow.length; row++) {
      value[row] = loops.value[loopRow[row]];
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      value[loopRow.length + ball] = 0.5 * (square(q, coordinates.ballPosition(ball)) - 1);
    }
  }

  private static double square(double[] q, int at) {
    return q[at] * q[at] + q[at + 1] * q[at + 1] + q[at + 2] * q[at + 2] + q[at + 3] * q[at + 3];
  }

  /** Forms the matrix from J, which must be evaluated. */
  public void differentiate(double[] q) {
    for (int e = 0; e < ofVelocity.length; e++) {
      if (ofVelocity[e] >= 0) {
        matrix.value[e] = loops.jacobian.value[ofVelocity[e]];
      }
    }
    for (int i = 0; i < balls.size(); i++) {
      differentiateBall(q, balls.get(i));
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int norm = matrix.start[loopRow.length + ball];
      System.arraycopy(q, coordinates.ballPosition(ball), matrix.value, norm, 4);
    }
  }

  /** δθ = 2 vec(δe ∘ e*) / |e|² = 2 (e0 δe_v − δe0 e_v + e_v × δe_v) / |e|², row · δθ. */
  private void differentiateBall(double[] q, BallElements elements) {
    int at = coordinates.ballPosition(elements.ball);
    double scale = 2 / square(q, at);
    double w = scale * q[at];
    double x = scale * q[at + 1];
    double y = scale * q[at + 2];
    double z = scale * q[at + 3];
    double jx = loops.jacobian.value[elements.ofVelocity];
    double jy = loops.jacobian.value[elements.ofVelocity + 1];
    double jz = loops.jacobian.value[elements.ofVelocity + 2];
    int p = elements.element;
    matrix.value[p] = -(jx * x + jy * y + jz * z);
    matrix.value[p + 1] = w * jx + z * jy - y * jz;
    matrix.value[p + 2] = w * jy + x * jz - z * jx;
    matrix.value[p + 3] = w * jz + y * jx - x * jy;
  }
}
