package org.mechservice.solver.force.law;

import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.mechanism.force.Side;

/**
 * A spring and damper of one coordinate z with rate z′: the tension T, positive against growing z.
 * With x = z − z0: T = F0 + k x + c x′ on both sides, the push of a {@link OneSidedLaw} of x above,
 * and its opposite with y = −x below. Coefficients in the order k, c, z0, F0, ε, χ.
 */
final class ScalarSpring {
  private static final String[] NAMES = {
    "stiffness", "damping", "rest position", "preload", "smoothing", "dissipation"
  };

  private final Side side;
  private final OneSidedLaw push = new OneSidedLaw();
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
    return side == Side.BOTH || isOneSided(coefficients, force);
  }

  private boolean isOneSided(Coefficients coefficients, AppliedForce force) {
    if (preload != 0) {
      return force.refuse(NAMES[3], preload, "zero for a force that acts on one side only");
    }
    for (int i : new int[] {0, 1, 5}) {
      if (coefficients.at(i) < 0) {
        return force.refuse(NAMES[i], coefficients.at(i), "zero or positive");
      }
    }
    push.set(k, 1, c, coefficients.at(5), eps);
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
    push.evaluate(sign * x, sign * rate);
    tension = sign * push.force();
    dampingForce = sign * (push.force() - push.elastic());
    byPosition = push.byDepth();
    byVelocity = push.byRate();
  }

  double tension() {
    return tension;
  }

  /** Returns the part of the tension without potential energy: that of the damper. */
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
      case ABOVE -> push.potentialEnergy(x);
      case BELOW -> push.potentialEnergy(-x);
    };
  }

  /** Returns the sum of the absolute terms of the tension at z = 0. */
  double scale() {
    return Math.abs(preload) + Math.abs(k) * (Math.abs(rest) + eps);
  }
}
