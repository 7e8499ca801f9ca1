package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * Normal force and friction of a surface. Legend: (x, y, z) the centre in the surface's frame; d =
 * R + h(x) − z; N = k pos(d)ⁿ + c d′ pos′(d); (sx, sy) sliding velocity at the lowest point.
 */
final class ContactTerm implements ForceTerm {
  /**
   * Numbers of a contact.
   *
   * @param radius m
   * @param stiffness N/mⁿ
   * @param damping N·s/m
   * @param exponent n
   * @param smoothing ε of pos, m
   * @param friction coefficient
   * @param frictionSpeed m/s
   */
  record Coefficients(
      Scalar radius,
      Scalar stiffness,
      Scalar damping,
      double exponent,
      double smoothing,
      Scalar friction,
      Scalar frictionSpeed) {}

  private final RelativeFrameMotion frames;
  private final Coefficients c;
  private final Scalar slope;
  private final SmoothPart part;
  private final Scalar depth;
  private final Scalar depthRate;
  private final Scalar normal;
  private final Scalar slideX;
  private final Scalar slideY;
  private final Scalar fx;
  private final Scalar fy;

  /**
   * @param frames the sphere's frame (any axes) relative to the surface's
   * @param height of the profile under the centre, m
   * @param slope its derivative
   */
  ContactTerm(RelativeFrameMotion frames, Coefficients coefficients, Scalar height, Scalar slope) {
    this.frames = frames;
    this.c = coefficients;
    this.slope = slope;
    Expressions e = height.expressions();
    ScalarVector u = frames.rate();
    ScalarVector omega = frames.omega();
    depth = c.radius().plus(height).minus(frames.displacement().z());
    depthRate = slope.times(u.x()).minus(u.z());
    part = new SmoothPart(depth, c.smoothing());
    normal = push().plus(c.damping().times(depthRate.times(part.slope())));
    slideX = u.x().minus(c.radius().times(omega.y()));
    slideY = u.y().plus(c.radius().times(omega.x()));
    Scalar root =
        slideX.squared().plus(slideY.squared()).plus(c.frictionSpeed().squared()).squareRoot();
    boolean rubs = !c.friction().isZero();
    fx = rubs ? c.friction().negated().times(slideX.over(root).times(normal)) : e.zero();
    fy = rubs ? c.friction().negated().times(slideY.over(root).times(normal)) : e.zero();
  }

  private Scalar push() {
    return c.stiffness().times(part.power(c.exponent()));
  }

  @Override
  public void apply(Loads loads) {
    Scalar zero = depth.expressions().zero();
    ScalarVector force = new ScalarVector(fx.minus(normal.times(slope)), fy, normal);
    ScalarVector moment =
        new ScalarVector(c.radius().times(fy), c.radius().negated().times(fx), zero);
    frames.addWrench(force, moment, loads);
  }

  @Override
  public Scalar potential() {
    return c.stiffness().times(part.integral(c.exponent()));
  }

  /** {@inheritDoc} It is the power of the wrench plus the rate of the potential energy. */
  @Override
  public Scalar power() {
    Scalar friction = fx.times(slideX).plus(fy.times(slideY));
    return friction.minus(normal.times(depthRate)).plus(push().times(depthRate));
  }

  @Override
  public List<Scalar> values() {
    return List.of(depth, normal, fx, fy);
  }
}
