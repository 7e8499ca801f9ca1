package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.mechanism.force.SpringDamper;

/**
 * Tension T(L, L′) along the line between two points. Legend: n the unit vector from point 1 to
 * point 2, so that the force on body 2 is −T n.
 */
public final class SpringDamperLaw implements FrameLaw {
  /** Tension, relative to the largest of its terms, below which coinciding points are permitted. */
  private static final double NO_TENSION = 1e-9;

  private final Coefficients coefficients;
  private final ScalarSpring spring;
  private final double[] n = new double[3];
  private double length;
  private double rate;

  public SpringDamperLaw(SpringDamper element) {
    coefficients =
        new Coefficients(
            element.name(),
            List.of(
                element.stiffness(),
                element.damping(),
                element.length0(),
                element.force0(),
                element.smoothing(),
                element.dissipation()));
    spring = new ScalarSpring(element.side());
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    return spring.parameters(coefficients, values, force);
  }

  @Override
  public boolean wrench(FrameMotion x, double[] w, AppliedForce force) {
    double[] r = x.displacement;
    length = Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    w[0] = 0;
    w[1] = 0;
    w[2] = 0;
    if (length == 0) {
      return wrenchWithoutLine(x, w, force);
    }
    rate = 0;
    for (int i = 0; i < 3; i++) {
      n[i] = r[i] / length;
      rate += n[i] * x.twist[3 + i];
    }
    spring.evaluate(length, rate);
    for (int i = 0; i < 3; i++) {
      w[3 + i] = -spring.tension() * n[i];
    }
    return true;
  }

  /**
   * Evaluates the force if the points coincide. The line is then taken along the velocity: a damper
   * without preload passes through zero length smoothly.
   */
  private boolean wrenchWithoutLine(FrameMotion x, double[] w, AppliedForce force) {
    spring.evaluate(0, 0);
    if (Math.abs(spring.tension()) > NO_TENSION * spring.scale()) {
      return force.fail(
          MessageCode.FORCE_WITHOUT_DIRECTION,
          "Its two points coincide, so its tension of " + spring.tension() + " N has no direction.",
          "Move one of the points, or use a bushing, which needs no direction.");
    }
    double speed = 0;
    for (int i = 3; i < 6; i++) {
      speed += x.twist[i] * x.twist[i];
    }
    rate = Math.sqrt(speed);
    spring.evaluate(0, rate);
    for (int i = 0; i < 3; i++) {
      n[i] = rate == 0 ? 0 : x.twist[3 + i] / rate;
      w[3 + i] = -spring.dampingForce() * n[i];
    }
    return true;
  }

  /**
   * −∂(T n): with P = I − n nᵀ, dn = P dr / L, dL = n · dr, dL′ = n · du + u · P dr / L. At zero
   * length the spring's force is opposite to any displacement.
   */
  @Override
  public void jacobian(FrameMotion x, double[] byPlace, double[] byVelocity) {
    double byLength = spring.byPosition();
    double byRate = spring.byVelocity();
    double perLength = length == 0 ? byLength : spring.tension() / length;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double across = (i == j ? 1 : 0) - n[i] * n[j];
        double acrossVelocity = length == 0 ? 0 : (x.twist[3 + j] - rate * n[j]) / length;
        int at = 6 * (3 + i) + 3 + j;
        byPlace[at] =
            -(perLength * across + byLength * n[i] * n[j] + byRate * n[i] * acrossVelocity);
        byVelocity[at] = -byRate * (length == 0 && i == j ? 1 : length == 0 ? 0 : n[i] * n[j]);
      }
    }
  }

  @Override
  public double potentialEnergy(FrameMotion x) {
    return spring.potentialEnergy(length);
  }

  @Override
  public double energyRate(FrameMotion x) {
    return (spring.tension() - spring.dampingForce()) * rate;
  }

  @Override
  public void values(FrameMotion x, double[] out, int at) {
    out[at] = length;
    out[at + 1] = rate;
    out[at + 2] = spring.tension();
  }
}
