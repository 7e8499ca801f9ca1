package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A spring and a damper along the line between two points.
 *
 * <p>With the length L of the line and x = L − length0, the tension (positive pulls the points
 * together) is
 *
 * <ul>
 *   <li>{@code BOTH}: T = force0 + k x + c x′;
 *   <li>{@code ABOVE}: T = max(0, k pos(x) (1 + χ x′) + c x′ pos′(x)), a rope or belt: it pulls and
 *       never pushes;
 *   <li>{@code BELOW}: T = −max(0, k pos(y) (1 + χ y′) + c y′ pos′(y)) with y = −x, a buffer: it
 *       pushes and never pulls.
 * </ul>
 *
 * Energy: ½ k x² + force0 x, or k ∫ pos with its zero at x = 0; power lost: the rest of the tension
 * times x′. The line has no direction if the points coincide; the run then ends with a message
 * naming the force, unless the tension is exactly zero.
 *
 * @param name name in the model file
 * @param point1 one end
 * @param point2 the other end
 * @param stiffness k, N/m
 * @param damping c, N·s/m
 * @param length0 length of the unstretched spring, m
 * @param force0 tension at {@code length0}, N; zero unless {@code side} is {@code BOTH}
 * @param side side on which it acts
 * @param smoothing ε of pos, m, not negative; not used for {@code BOTH}
 * @param dissipation χ, s/m, not negative; zero for {@code BOTH}
 * @param origin position in the model file
 */
public record SpringDamper(
    String name,
    BodyPoint point1,
    BodyPoint point2,
    Expression stiffness,
    Expression damping,
    Expression length0,
    Expression force0,
    Side side,
    Expression smoothing,
    Expression dissipation,
    Origin origin)
    implements ForceElement {
  /** A spring without χ. */
  public SpringDamper(
      String name,
      BodyPoint point1,
      BodyPoint point2,
      Expression stiffness,
      Expression damping,
      Expression length0,
      Expression force0,
      Side side,
      Expression smoothing,
      Origin origin) {
    this(
        name,
        point1,
        point2,
        stiffness,
        damping,
        length0,
        force0,
        side,
        smoothing,
        Expression.ZERO,
        origin);
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("length", "m"), new Variable("rate", "m/s"), new Variable("tension", "N"));
  }

  /** {@inheritDoc} k, c, length0, tension there, ε, χ. */
  @Override
  public List<Coefficient> coefficients() {
    return SpringCoefficients.of(side, stiffness, damping, length0, force0, smoothing, dissipation);
  }

  /** Returns its law. */
  public PairLaw pairLaw() {
    return PairLaw.ofSpring(side);
  }

  @Override
  public String kind() {
    return "spring between points";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.springDamper(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(point1.body(), point2.body());
  }
}
