package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A user force class, see {@code org.mechservice.solver.api.UserForce}.
 *
 * <p>This record describes the class and the names that it may use; the class is loaded only in the
 * process that runs the model.
 *
 * @param name name in the model file
 * @param className fully qualified name of the class
 * @param points every point of the model file, for use by the class
 * @param origin position in the model file
 */
public record UserForceElement(
    String name, String className, List<NamedPoint> points, Origin origin) implements ForceElement {

  public UserForceElement {
    points = List.copyOf(points);
  }

  /** {@inheritDoc} Empty: the class declares its values. */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of();
  }

  @Override
  public String kind() {
    return "class " + className;
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.userForce(this);
  }

  @Override
  public List<Integer> bodies() {
    return points.stream().map(named -> named.point().body()).toList();
  }
}
