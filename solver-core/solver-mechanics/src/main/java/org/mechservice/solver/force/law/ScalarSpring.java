package org.mechservice.solver.force.law;

import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.mechanism.force.Side;

/**
 * A spring and damper of one coordinate z with rate z′: the tension T, positive against growing z.
 * With x = z − z0: T = F0 + k x + c x′ on both sides, k pos(x) + c x′ pos′(x) above, −(k pos(y) + c
 * y′ pos′(y)) with y = −x below. Coefficients in the order k, c, z0, F0, ε.
 */
final class ScalarSpring {
  private static final String[] NAMES = {
    "stiffness", "damping", "rest position", "preload", "smoothing"
  };

  private final Side side;
  private double k;
  private double c;
  private double rest;
  private double preload;
  private double eps;
  private double tension;
  private double dampingForce;
  private double byPosition;
  private double byVelocity;

  ScalarSpring(Side side) {
    this.side = side;
  }

  boolean parameters(Coefficients coefficients, double[] values, AppliedForce force) {
    int bad = coefficients.update(values);
    if (bad >= 0) {
      return force.refuse(NAMES[bad], coefficients.at(bad), "finite");
    }
    k = coefficients.at(0);
    c = coefficients.at(1);
    rest = coefficients.at(2);
    preload = coefficients.at(3);
    eps = coefficients.at(4);
    if (eps < 0) {
      return force.refuse(NAMES[4], eps, "zero or positive");
    }
    if (side != Side.BOTH && preload != 0) {
      return force.refuse(NAMES[3], preload, "zero for a force that acts on one side only");
    }
    return true;
  }

  /** Evaluates the tension and its derivatives. */
  void evaluate(double z, double rate) {
    double x = z - rest;
    if (side == Side.BOTH) {
      dampingForce = c * rate;
      tension = preload + k * x + dampingForce;
      byPosition = k;
      byVelocity = c;
      return;
    }
    double sign = side == Side.ABOVE ? 1 : -1;
    double slope = SmoothPositive.slope(sign * x, eps);
    dampingForce = c * rate * slope;
    tension = sign * k * SmoothPositive.value(sign * x, eps) + dampingForce;
    byPosition = k * slope + sign * c * rate * SmoothPositive.bend(sign * x, eps);
    byVelocity = c * slope;
  }

  double tension() {
    return tension;
  }

  /** Returns the part of the tension that comes from the damper. */
  double dampingForce() {
    return dampingForce;
  }

  double byPosition() {
    return byPosition;
  }

  double byVelocity() {
    return byVelocity;
  }

  /** Returns the energy of spring and preload, zero at the rest position. */
  double potentialEnergy(double z) {
    double x = z - rest;
    return switch (side) {
      case BOTH -> (0.5 * k * x + preload) * x;
      case ABOVE -> k * SmoothPositive.integral(x, eps, 1);
      case BELOW -> k * SmoothPositive.integral(-x, eps, 1);
    };
  }

  /** Returns the sum of the absolute terms of the tension at z = 0. */
  double scale() {
    return Math.abs(preload) + Math.abs(k) * (Math.abs(rest) + eps);
  }
}
