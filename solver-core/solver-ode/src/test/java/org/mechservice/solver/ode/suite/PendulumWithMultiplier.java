package org.mechservice.solver.ode.suite;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * A pendulum in Cartesian coordinates, its rod's constraint differentiated twice: of index 1, with
 * the multiplier as algebraic component. Hairer and Wanner II, VII.1.
 *
 * <p>End value to 21 digits by elliptic functions.
 */
public final class PendulumWithMultiplier implements ResidualProblem {
  private static final double GRAVITY = 9.81;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          10,
          new double[] {1, 0, 0, 0, 0},
          new double[] {1, 1, 1, 1, 1},
          new double[] {
            0.2750874625761169,
            -0.961419205099125,
            -4.175598100951729,
            -1.1947490545604753,
            28.29456720606725
          },
          4,
          new double[] {
            -0.5775636282486314,
            -0.8163456714678389,
            3.2670865745707705,
            -2.311460012299246,
            24.025053111298497
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public double[] initialDerivative() {
    return new double[] {0, 0, 0, -GRAVITY, 0};
  }

  @Override
  public List<ToDoubleFunction<double[]>> invariants() {
    return List.of(y -> y[0] * y[0] + y[1] * y[1] - 1, y -> y[0] * y[2] + y[1] * y[3]);
  }

  @Override
  public Component component(int index) {
    return index == 4 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    residual[0] = yDot[0] - y[2];
    residual[1] = yDot[1] - y[3];
    residual[2] = yDot[2] + y[0] * y[4];
    residual[3] = yDot[3] + GRAVITY + y[1] * y[4];
    residual[4] = y[0] * yDot[2] + y[1] * yDot[3] + y[2] * y[2] + y[3] * y[3];
  }
}
