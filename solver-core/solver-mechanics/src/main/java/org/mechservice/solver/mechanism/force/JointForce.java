package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A force in a joint, given by an expression. A positive force increases the coordinate, so its
 * power is force · v. It has no potential energy.
 *
 * @param name name in the model file
 * @param coordinate component counts velocities
 * @param force of t, parameters and the state, N·m or N
 * @param origin position in the model file
 */
public record JointForce(String name, Coordinate coordinate, Expression force, Origin origin)
    implements ForceElement {

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    String unit = jointOf.apply(coordinate).forceUnit(coordinate.component());
    return List.of(new Variable("force", unit));
  }

  @Override
  public String kind() {
    return "force in a joint";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.jointForce(this);
  }

  @Override
  public Optional<Coordinate> jointCoordinate() {
    return Optional.of(coordinate);
  }

  @Override
  public List<Formula> formulas() {
    return List.of(new Formula("joint force", force));
  }
}
