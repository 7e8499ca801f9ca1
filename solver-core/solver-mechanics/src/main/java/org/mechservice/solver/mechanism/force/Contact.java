package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * Contact of a sphere or a point with a surface, which exerts a push but no pull.
 *
 * <p>A frame carries the surface: its height h above the frame's x-y plane (z points out of the
 * ground) is zero for a plane, or a profile h(x) that does not depend on y. With the centre (x, y,
 * z) of the sphere in the frame, the penetration is d = radius + h(x) − z, measured along z. The
 * push along z on the sphere is
 *
 * <p>N = k pos(d)ⁿ + c d′ pos′(d),
 *
 * <p>and the normal force of the surface on the centre is (−N h′, 0, N). Friction acts at the
 * lowest point of the sphere (radius below the centre, along z): −friction · N · u / √(|u|² +
 * frictionSpeed²), u the velocity along x and y of the body's point there relative to the surface.
 * The opposite forces act on the body of the surface at the same points. A steep profile needs a
 * small radius, because distances are measured along z, not normal to the slope.
 *
 * <p>Energy: k ∫ posⁿ (zero at d = 0 for n = 1, at d = −∞ for n &gt; 1); power lost: c d′² pos′(d)
 * and the work of friction. The damper can pull for an instant while the sphere leaves; friction
 * has the sign of N, so that all forces stay smooth.
 *
 * @param name name in the model file
 * @param center centre of the sphere, or the point
 * @param radius of the sphere, m; 0 for a point
 * @param surface frame of the surface, z outwards
 * @param height h of {@link Expression.Argument} and parameters, m; {@code Expression.ZERO} for a
 *     plane
 * @param stiffness k, N/mⁿ
 * @param damping c, N·s/m
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
    Expression stiffness,
    Expression damping,
    Expression exponent,
    Expression smoothing,
    Expression friction,
    Expression frictionSpeed,
    Origin origin)
    implements ForceElement {

  /** {@inheritDoc} Penetration, push, friction along the frame's x and y. */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("penetration", "m"),
        new Variable("normal", "N"),
        new Variable("frictionX", "N"),
        new Variable("frictionY", "N"));
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
