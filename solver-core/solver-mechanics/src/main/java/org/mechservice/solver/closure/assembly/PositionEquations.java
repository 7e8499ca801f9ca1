package org.mechservice.solver.closure.assembly;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.StateCoordinates;

/**
 * The equations of the positions of the state: Φ(q, t) = 0 and, for each set of Euler parameters,
 * (|e|² − 1)/2 = 0, with their derivatives by q. Workspace of one thread.
 */
public final class PositionEquations {
  private final LoopEquations loops;
  private final StateCoordinates coordinates;

  /** Number of equations, that of Φ first. */
  public final int count;

  /** Number of positions. */
  final int unknowns;

  /** Left sides. */
  public final double[] value;

  /** ∂/∂q, row by row. */
  public final double[] matrix;

  public PositionEquations(LoopEquations loops, StateCoordinates coordinates) {
    this.loops = loops;
    this.coordinates = coordinates;
    count = loops.count() + coordinates.ballCount();
    unknowns = coordinates.positionCount();
    value = new double[count];
    matrix = new double[count * unknowns];
  }

  /** Takes Φ and the norms; the equations are placed. */
  public void evaluate(double[] q) {
    System.arraycopy(loops.value, 0, value, 0, loops.count());
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      value[loops.count() + ball] = 0.5 * (square(q, coordinates.ballPosition(ball)) - 1);
    }
  }

  private static double square(double[] q, int at) {
    return q[at] * q[at] + q[at + 1] * q[at + 1] + q[at + 2] * q[at + 2] + q[at + 3] * q[at + 3];
  }

  /** Forms the matrix from J, which is evaluated. */
  public void differentiate(double[] q) {
    Arrays.fill(matrix, 0);
    for (int row = 0; row < loops.count(); row++) {
      for (int i = 0; i < unknowns; i++) {
        int velocity = coordinates.velocityOf(i);
        if (velocity >= 0) {
          matrix[row * unknowns + i] = loops.jacobian[row * loops.width() + velocity];
        }
      }
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      differentiateBall(q, ball);
    }
  }

  /** δθ = 2 vec(δe ∘ e*) / |e|² = 2 (e0 δe_v − δe0 e_v + e_v × δe_v) / |e|², row · δθ. */
  private void differentiateBall(double[] q, int ball) {
    int at = coordinates.ballPosition(ball);
    int velocity = coordinates.ballVelocity(ball);
    double scale = 2 / square(q, at);
    double w = scale * q[at];
    double x = scale * q[at + 1];
    double y = scale * q[at + 2];
    double z = scale * q[at + 3];
    for (int row = 0; row < loops.count(); row++) {
      int j = row * loops.width() + velocity;
      double jx = loops.jacobian[j];
      double jy = loops.jacobian[j + 1];
      double jz = loops.jacobian[j + 2];
      int p = row * unknowns + at;
      matrix[p] = -(jx * x + jy * y + jz * z);
      matrix[p + 1] = w * jx + z * jy - y * jz;
      matrix[p + 2] = w * jy + x * jz - z * jx;
      matrix[p + 3] = w * jz + y * jx - x * jy;
    }
    int norm = (loops.count() + ball) * unknowns + at;
    System.arraycopy(q, at, matrix, norm, 4);
  }
}
