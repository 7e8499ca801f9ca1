package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Push and friction of a surface on a sphere at the closest point of one curve. Legend: R the
 * radius; (x, y, z) the centre in the surface's frame; n = (−sin θ, 0, cos θ) the normal and t =
 * (cos θ, 0, sin θ) the tangent; (s, r) sliding velocity along t and y at the point R below the
 * centre along n; p = √(s² + r² + v0²), v0 the friction speed.
 */
public final class ContactLoad implements PairLoad {
  /** Names of the coefficients in printed methods, with those of the closest point. */
  static final List<String> SYMBOLS =
      List.of(
          "radius",
          "stiffness",
          "damping",
          "chi",
          "exponent",
          "eps",
          "friction",
          "frictionSpeed",
          "s",
          "height",
          "slope",
          "bend",
          "below");

  /**
   * Coefficients of a contact.
   *
   * @param radius m
   * @param push law of the push
   * @param friction coefficient
   * @param frictionSpeed m/s
   */
  public record Coefficients(Scalar radius, PushLaw push, Scalar friction, Scalar frictionSpeed) {
    /**
     * Returns the coefficients in the order of the element: radius, stiffness, damping,
     * dissipation, exponent, smoothing, friction, friction speed.
     */
    public static Coefficients of(List<Scalar> c) {
      PushLaw push = new PushLaw(c.get(1), c.get(4), c.get(2), c.get(3), c.get(5));
      return new Coefficients(c.get(0), push, c.get(6), c.get(7));
    }
  }

  private final Coefficients c;
  private final ClosestFoot foot;
  private final Scalar depth;
  private final Scalar depthRate;
  private final Scalar normal;
  private final Scalar slideAlong;
  private final Scalar slideAcross;
  private final Scalar along;
  private final Scalar across;

  /**
   * @param frames the sphere's frame (any axes) relative to the surface's
   * @param foot the closest point of the curve
   */
  public ContactLoad(Frames frames, Coefficients coefficients, ClosestFoot foot) {
    this.c = coefficients;
    this.foot = foot;
    Expressions e = foot.distance.expressions();
    Scalar reach = foot.isOfCentre() ? e.zero() : c.radius();
    ScalarVector u = frames.rate();
    ScalarVector omega = frames.omega();
    Scalar sine = foot.sine;
    Scalar cosine = foot.cosine;
    depth = reach.minus(foot.distance);
    depthRate = sine.times(u.x()).minus(cosine.times(u.z()));
    normal = c.push().force(depth, depthRate);
    Scalar slip = cosine.times(u.x()).plus(sine.times(u.z()));
    Scalar spin = cosine.times(omega.x()).plus(sine.times(omega.z()));
    slideAlong = slip.minus(omega.y().times(c.radius()));
    slideAcross = u.y().plus(spin.times(c.radius()));
    if (c.friction().isZero()) {
      along = e.zero();
      across = e.zero();
      return;
    }
    Scalar squares = slideAlong.squared().plus(slideAcross.squared());
    Scalar root = squares.plus(c.frictionSpeed().squared()).squareRoot();
    Scalar most = normal.times(c.friction().negated());
    along = whereRough(slideAlong.over(root).times(most));
    across = whereRough(slideAcross.over(root).times(most));
  }

  /** Returns 0 without friction, where no friction speed is needed. */
  private Scalar whereRough(Scalar force) {
    Expressions e = force.expressions();
    return c.friction().isConstant()
        ? force
        : e.function(MathFunction.CHOOSE, c.friction(), e.zero(), e.zero(), force);
  }

  @Override
  public ScalarVector force() {
    Scalar sine = foot.sine;
    Scalar cosine = foot.cosine;
    return new ScalarVector(
        cosine.times(along).minus(sine.times(normal)),
        across,
        sine.times(along).plus(cosine.times(normal)));
  }

  @Override
  public ScalarVector moment() {
    Scalar lever = across.times(c.radius());
    return new ScalarVector(
        lever.times(foot.cosine), along.times(c.radius().negated()), lever.times(foot.sine));
  }

  @Override
  public Scalar potential() {
    return c.push().potential(depth);
  }

  @Override
  public Scalar power() {
    Scalar friction = along.times(slideAlong).plus(across.times(slideAcross));
    return friction.minus(c.push().dissipative(depth, depthRate).times(depthRate));
  }

  /** {@inheritDoc} Penetration, push, friction along t and along y. */
  @Override
  public List<Scalar> values() {
    return List.of(depth, normal, along, across);
  }
}
