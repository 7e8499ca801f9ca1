package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * Contact of a sphere or a point with a surface, which pushes and never pulls.
 *
 * <p>A frame carries the surface: its height h above the frame's x-y plane (z points out of the
 * ground) is zero for a plane, or a profile h(x) that does not depend on y. The sphere touches with
 * its surface: with the point of the curve z = h(x) that is closest to the centre, and the normal n
 * there, the penetration is d = radius − distance, measured along n. The push along n on the sphere
 * is
 *
 * <p>N = max(0, k pos(d)ⁿ (1 + χ d′) + c d′ pos′(d)).
 *
 * <p>Friction acts at the point of the sphere that is radius below its centre along n: −friction ·
 * N · u / √(|u|² + frictionSpeed²), u the velocity of the body's point there relative to the
 * surface, in the tangent plane. The opposite forces act on the body of the surface at the same
 * points.
 *
 * <p>Where the surface bends more than the sphere, the sphere touches at several points at once.
 * {@code tracks} has the curves on which its centre moves while it touches each of them; depth and
 * normal are then those of the centre and the closest point of each track. Without tracks only the
 * closest of the points pushes.
 *
 * <p>Energy: k ∫ posⁿ (zero at d = 0 for n = 1, at d = −∞ for n &gt; 1); the rest of the push and
 * friction do work.
 *
 * @param name name in the model file
 * @param center centre of the sphere, or the point
 * @param radius of the sphere, m; 0 for a point
 * @param surface frame of the surface, z outwards
 * @param height h of {@link Expression.Argument} and parameters, m; {@code Expression.ZERO} for a
 *     plane
 * @param tracks heights of the centre of the touching sphere, of {@link Expression.Argument}, m;
 *     empty if the surface bends less than the sphere
 * @param stiffness k, N/mⁿ
 * @param damping c, N·s/m
 * @param dissipation χ, s/m
 * @param exponent n ≥ 1
 * @param smoothing ε of pos, m, not negative
 * @param friction coefficient, not negative
 * @param frictionSpeed sliding speed at which friction has 1/√2 of its full force, m/s, positive
 * @param origin position in the model file
 */
public record Contact(
    String name,
    BodyPoint center,
    Expression radius,
    BodyFrame surface,
    Expression height,
    List<Expression> tracks,
    Expression stiffness,
    Expression damping,
    Expression dissipation,
    Expression exponent,
    Expression smoothing,
    Expression friction,
    Expression frictionSpeed,
    Origin origin)
    implements ForceElement {
  public Contact {
    tracks = List.copyOf(tracks);
  }

  /** A contact without χ, with a surface that bends less than the sphere. */
  public Contact(
      String name,
      BodyPoint center,
      Expression radius,
      BodyFrame surface,
      Expression height,
      Expression stiffness,
      Expression damping,
      Expression exponent,
      Expression smoothing,
      Expression friction,
      Expression frictionSpeed,
      Origin origin) {
    this(
        name,
        center,
        radius,
        surface,
        height,
        List.of(),
        stiffness,
        damping,
        Expression.ZERO,
        exponent,
        smoothing,
        friction,
        frictionSpeed,
        origin);
  }

  /**
   * {@inheritDoc} Penetration (of the deepest point), push, friction along the profile and along
   * the frame's y.
   */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("penetration", "m"),
        new Variable("normal", "N"),
        new Variable("frictionX", "N"),
        new Variable("frictionY", "N"));
  }

  /** {@inheritDoc} R, k, c, χ, n, ε, friction and its speed. */
  @Override
  public List<Coefficient> coefficients() {
    return List.of(
        new Coefficient("radius", radius, Condition.NOT_NEGATIVE),
        new Coefficient("stiffness", stiffness, Condition.NOT_NEGATIVE),
        new Coefficient("damping", damping, Condition.NOT_NEGATIVE),
        new Coefficient("dissipation", dissipation, Condition.NOT_NEGATIVE),
        new Coefficient("exponent", exponent, Condition.AT_LEAST_ONE),
        new Coefficient("smoothing", smoothing, Condition.NOT_NEGATIVE),
        new Coefficient("friction coefficient", friction, Condition.NOT_NEGATIVE),
        new Coefficient("friction speed", frictionSpeed, Condition.POSITIVE_WITH_FRICTION));
  }

  /** Returns its law at one of its curves. */
  public PairLaw pairLaw() {
    return tracks.isEmpty() ? PairLaw.CONTACT : PairLaw.CONTACT_OF_CENTRE;
  }

  @Override
  public String kind() {
    return "contact";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.contact(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(surface.body(), center.body());
  }
}
