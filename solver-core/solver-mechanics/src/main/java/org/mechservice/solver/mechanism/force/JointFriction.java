package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * Dry and viscous friction in a joint: τ = −coulomb · v / √(v² + speed²) − viscous · v.
 *
 * <p>The dry part is smooth, so it does not hold a load at rest: the joint creeps at about speed ·
 * load / coulomb. It does not depend on the joint's reaction; {@code coulomb} is the friction
 * force. Power lost: −τ v ≥ 0; no energy.
 *
 * @param name name in the model file
 * @param coordinate component counts velocities
 * @param coulomb dry friction force far above {@code speed}, N·m or N, not negative
 * @param viscous N·m·s/rad or N·s/m, not negative
 * @param speed velocity at which dry friction has 1/√2 of its full force, rad/s or m/s, positive
 * @param origin position in the model file
 */
public record JointFriction(
    String name,
    Coordinate coordinate,
    Expression coulomb,
    Expression viscous,
    Expression speed,
    Origin origin)
    implements ForceElement {

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    String unit = jointOf.apply(coordinate).forceUnit(coordinate.component());
    return List.of(new Variable("force", unit));
  }

  /** {@inheritDoc} Coulomb friction, speed, viscous friction. */
  @Override
  public List<Coefficient> coefficients() {
    return List.of(
        new Coefficient("dry friction", coulomb, Condition.NOT_NEGATIVE),
        new Coefficient("friction speed", speed, Condition.POSITIVE_WITH_FRICTION),
        new Coefficient("viscous friction", viscous, Condition.NOT_NEGATIVE));
  }

  @Override
  public String kind() {
    return "friction in a joint";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.jointFriction(this);
  }

  @Override
  public Optional<Coordinate> jointCoordinate() {
    return Optional.of(coordinate);
  }
}
