package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A spring and a damper in a joint, or a stop of its motion.
 *
 * <p>With x = q − position0, the force on the coordinate (positive increases it) is
 *
 * <ul>
 *   <li>{@code BOTH}: τ = force0 − k x − c v;
 *   <li>{@code ABOVE}: τ = −max(0, k pos(x) (1 + χ v) + c v pos′(x)), an upper stop;
 *   <li>{@code BELOW}: τ = max(0, k pos(−x) (1 − χ v) − c v pos′(−x)), a lower stop.
 * </ul>
 *
 * A stop pushes and never pulls. Energy: ½ k x² − force0 x, or k ∫ pos with its zero at x = 0;
 * power lost: the rest of the force times v. Stiffness and damping of an angle are per radian.
 * Joints with Euler parameters have displacements only (F, components 4 to 6 as positions).
 *
 * @param name name in the model file
 * @param coordinate component counts positions; its position must have a velocity of its own
 * @param stiffness k, N·m/rad or N/m
 * @param damping c, N·m·s/rad or N·s/m
 * @param position0 position of the unloaded spring, rad or m
 * @param force0 force at {@code position0} on the coordinate, N·m or N; zero unless {@code side} is
 *     {@code BOTH}
 * @param side side on which it acts
 * @param smoothing ε of pos, rad or m, not negative; not used for {@code BOTH}
 * @param dissipation χ, s/rad or s/m, not negative; zero for {@code BOTH}
 * @param origin position in the model file
 */
public record JointSpringDamper(
    String name,
    Coordinate coordinate,
    Expression stiffness,
    Expression damping,
    Expression position0,
    Expression force0,
    Side side,
    Expression smoothing,
    Expression dissipation,
    Origin origin)
    implements ForceElement {
  /** A spring without χ. */
  public JointSpringDamper(
      String name,
      Coordinate coordinate,
      Expression stiffness,
      Expression damping,
      Expression position0,
      Expression force0,
      Side side,
      Expression smoothing,
      Origin origin) {
    this(
        name,
        coordinate,
        stiffness,
        damping,
        position0,
        force0,
        side,
        smoothing,
        Expression.ZERO,
        origin);
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    JointType type = jointOf.apply(coordinate).type();
    boolean slides = type.positionUnit(coordinate.component()).equals("m");
    return List.of(new Variable("force", slides ? "N" : "N·m"));
  }

  /** {@inheritDoc} k, c, position0, tension there, ε, χ. */
  @Override
  public List<Coefficient> coefficients() {
    return SpringCoefficients.of(
        side,
        stiffness,
        damping,
        position0,
        new Expression.Negation(force0),
        smoothing,
        dissipation);
  }

  @Override
  public String kind() {
    return "spring in a joint";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.jointSpringDamper(this);
  }

  @Override
  public Optional<Coordinate> jointCoordinate() {
    return Optional.of(coordinate);
  }
}
