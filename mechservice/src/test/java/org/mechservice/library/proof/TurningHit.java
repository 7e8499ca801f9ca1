package org.mechservice.library.proof;

/**
 * A point that turns about the origin, a slider, and a one-sided law between them: y = [a, x, w,
 * v]. The point is at r (cos a, sin a), the slider at (u0, z0) + x (ux, uz); gravity acts along the
 * first axis.
 *
 * @param inertia of the turning body about the origin
 * @param torque amplitude m g r of gravity on it: the torque is -torque sin a
 * @param arm r
 * @param mass of the slider
 * @param u0 first coordinate of the slider at x = 0
 * @param z0 second coordinate
 * @param ux direction of its motion
 * @param uz direction of its motion
 * @param stiffness of its spring
 * @param damping of its damper
 * @param radius distance at which the law begins
 * @param pulls whether it acts beyond this distance
 * @param law the law
 * @param on whether it acts at all
 * @param fine a short step, s
 */
record TurningHit(
    double inertia,
    double torque,
    double arm,
    double mass,
    double u0,
    double z0,
    double ux,
    double uz,
    double stiffness,
    double damping,
    double radius,
    boolean pulls,
    Law law,
    boolean on,
    double fine)
    implements PlainSystem {
  @Override
  public int states() {
    return 4;
  }

  private double dx(double[] y) {
    return u0 + y[1] * ux - arm * Math.cos(y[0]);
  }

  private double dz(double[] y) {
    return z0 + y[1] * uz - arm * Math.sin(y[0]);
  }

  private double sign() {
    return pulls ? -1 : 1;
  }

  private double depth(double[] y) {
    return sign() * (radius - Math.hypot(dx(y), dz(y)));
  }

  private double rate(double[] y) {
    double dx = dx(y);
    double dz = dz(y);
    double vx = y[3] * ux + arm * Math.sin(y[0]) * y[2];
    double vz = y[3] * uz - arm * Math.cos(y[0]) * y[2];
    return -sign() * (dx * vx + dz * vz) / Math.hypot(dx, dz);
  }

  @Override
  public void rates(double t, double[] y, boolean[] above, double[] rates) {
    double dx = dx(y);
    double dz = dz(y);
    double distance = Math.hypot(dx, dz);
    double force = on ? sign() * law.force(depth(y), rate(y), above) : 0;
    double fx = force * dx / distance;
    double fz = force * dz / distance;
    rates[0] = y[2];
    rates[1] = y[3];
    double lever = -fx * -arm * Math.sin(y[0]) + -fz * arm * Math.cos(y[0]);
    rates[2] = (lever - torque * Math.sin(y[0])) / inertia;
    rates[3] = (fx * ux + fz * uz - stiffness * y[1] - damping * y[3]) / mass;
  }

  @Override
  public int margins() {
    return on ? law.margins() : 0;
  }

  @Override
  public double margin(int i, double t, double[] y) {
    return law.margin(i, depth(y), rate(y));
  }

  @Override
  public double clear(double t, double[] y) {
    double gap = -depth(y);
    if (!on) {
      return 1e6 * fine;
    }
    if (gap <= 0) {
      return 0;
    }
    double speed = Math.abs(y[3]) + arm * Math.abs(y[2]);
    double pull = arm * torque / inertia + (stiffness * Math.abs(y[1]) + damping * speed) / mass;
    return gap / (2 * (speed + Math.sqrt(pull * gap)) + 1e-300);
  }
}
