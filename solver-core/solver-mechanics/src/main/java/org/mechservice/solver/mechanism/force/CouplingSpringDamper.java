package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A spring and damper along a formula x of joint positions, places of points and time: the teeth of
 * a gear, a belt, a rope over pulleys. Its tension T acts against growing x with the generalised
 * force −T, so it exerts −T ∂x/∂q on every coordinate. With z = x − rest: T = force0 + k z + c z′
 * on both sides; on one side as {@link SpringDamper}, with χ. The potential energy is that of the
 * spring.
 *
 * @param name name in the model file
 * @param along x, of t, parameters, positions of coordinates that are no Euler parameters, and
 *     places of points; m or rad
 * @param angle whether x is an angle
 * @param stiffness k, N/m or N·m/rad
 * @param damping c, N·s/m or N·m·s/rad
 * @param rest x at rest, m or rad
 * @param force0 tension at rest, N or N·m; zero on one side
 * @param side where it acts
 * @param smoothing length or angle over which a force on one side sets in, m or rad
 * @param dissipation χ, s/m or s/rad, not negative; zero on both sides
 * @param watched formulas that tell where the form of x changes, which a step could pass over
 * @param points what a rope passes, in this order, for pictures; empty for other couplings
 * @param origin position in the model file
 */
public record CouplingSpringDamper(
    String name,
    Expression along,
    boolean angle,
    Expression stiffness,
    Expression damping,
    Expression rest,
    Expression force0,
    Side side,
    Expression smoothing,
    Expression dissipation,
    List<Expression> watched,
    List<BodyPoint> points,
    Origin origin)
    implements ForceElement {
  public CouplingSpringDamper {
    watched = List.copyOf(watched);
    points = List.copyOf(points);
  }

  /** A spring without χ. */
  public CouplingSpringDamper(
      String name,
      Expression along,
      boolean angle,
      Expression stiffness,
      Expression damping,
      Expression rest,
      Expression force0,
      Side side,
      Expression smoothing,
      List<BodyPoint> points,
      Origin origin) {
    this(
        name,
        along,
        angle,
        stiffness,
        damping,
        rest,
        force0,
        side,
        smoothing,
        Expression.ZERO,
        List.of(along),
        points,
        origin);
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return angle
        ? List.of(
            new Variable("angle", "rad"),
            new Variable("rate", "rad/s"),
            new Variable("torque", "N·m"))
        : List.of(
            new Variable("length", "m"), new Variable("rate", "m/s"), new Variable("tension", "N"));
  }

  /** {@inheritDoc} k, c, rest, tension there, ε, χ. */
  @Override
  public List<Coefficient> coefficients() {
    return SpringCoefficients.of(side, stiffness, damping, rest, force0, smoothing, dissipation);
  }

  @Override
  public String kind() {
    return "spring along a coupling";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.couplingSpringDamper(this);
  }

  @Override
  public List<Formula> formulas() {
    return List.of(new Formula(angle ? "angle" : "length", along));
  }
}
