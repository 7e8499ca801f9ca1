package org.mechservice.solver.ode.suite;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * A rigid slider crank with its two constraints differentiated twice: angles of crank and rod,
 * position of the slider, their velocities, two multipliers. Masses and lengths after Simeon 1996.
 *
 * <p>End value confirmed to 13.7 digits by collocation of two orders.
 */
public final class SliderCrank implements ResidualProblem {
  private static final double CRANK_MASS = 0.36;
  private static final double ROD_MASS = 0.151104;
  private static final double SLIDER_MASS = 0.075552;
  private static final double CRANK = 0.15;
  private static final double ROD = 0.30;
  private static final double CRANK_INERTIA = 0.002727;
  private static final double ROD_INERTIA = 0.0045339259;
  private static final double GRAVITY = 9.81;
  private static final double DRIVE = 0.01;
  private static final double DRIVE_SPEED = 150;
  private static final double SLIDER_DAMPING = 0.5;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          1,
          new double[] {
            0.7853981633974483,
            -0.36136712390670783,
            0.38669032118602775,
            0,
            0,
            0,
            0.15027842101780545,
            1.8588508425105787
          },
          new double[] {1, 1, 1, 10, 10, 10, 100, 100},
          new double[] {
            62.140965176473145,
            0.32426360963081846,
            0.39996776151132263,
            82.90283157285926,
            -33.702167242094994,
            11.145485632503584,
            -50.85458186723723,
            34.43786722301768
          },
          0.5,
          new double[] {
            21.19515137612215,
            -0.3653548936459997,
            0.17526322390669125,
            76.06930727399387,
            28.488313257480225,
            -5.099932490523139,
            -6.067636691945675,
            -32.71263318788753
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public double[] initialDerivative() {
    return new double[] {
      0, 0, 0, 168.33882649711651, -63.626095843974376, -24.603595437719434, 0, 0
    };
  }

  @Override
  public int scored() {
    return 6;
  }

  @Override
  public List<ToDoubleFunction<double[]>> invariants() {
    return List.of(
        y -> CRANK * StrictMath.sin(y[0]) + ROD * StrictMath.sin(y[1]),
        y -> y[2] - CRANK * StrictMath.cos(y[0]) - ROD * StrictMath.cos(y[1]));
  }

  @Override
  public Component component(int index) {
    return index >= 6 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    double sinCrank = StrictMath.sin(y[0]);
    double cosCrank = StrictMath.cos(y[0]);
    double sinRod = StrictMath.sin(y[1]);
    double cosRod = StrictMath.cos(y[1]);
    double coupling = 0.5 * CRANK * ROD * ROD_MASS * StrictMath.cos(y[0] - y[1]);
    double centrifugal = 0.5 * CRANK * ROD * ROD_MASS * StrictMath.sin(y[0] - y[1]);
    residual[0] = yDot[0] - y[3];
    residual[1] = yDot[1] - y[4];
    residual[2] = yDot[2] - y[5];
    residual[3] =
        (CRANK_INERTIA + ROD_MASS * CRANK * CRANK) * yDot[3]
            + coupling * yDot[4]
            + centrifugal * y[4] * y[4]
            + 0.5 * CRANK * GRAVITY * (CRANK_MASS + 2 * ROD_MASS) * cosCrank
            - DRIVE * (DRIVE_SPEED - y[3])
            + CRANK * (cosCrank * y[6] + sinCrank * y[7]);
    residual[4] =
        coupling * yDot[3]
            + ROD_INERTIA * yDot[4]
            - centrifugal * y[3] * y[3]
            + 0.5 * ROD * GRAVITY * ROD_MASS * cosRod
            + ROD * (cosRod * y[6] + sinRod * y[7]);
    residual[5] = SLIDER_MASS * yDot[5] + SLIDER_DAMPING * y[5] + y[7];
    residual[6] =
        CRANK * cosCrank * yDot[3]
            + ROD * cosRod * yDot[4]
            - CRANK * sinCrank * y[3] * y[3]
            - ROD * sinRod * y[4] * y[4];
    residual[7] =
        CRANK * sinCrank * yDot[3]
            + ROD * sinRod * yDot[4]
            + yDot[5]
            + CRANK * cosCrank * y[3] * y[3]
            + ROD * cosRod * y[4] * y[4];
  }
}
