package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Origin;

/**
 * A force that a user has written as a class, see {@code org.mechservice.solver.api.UserForce}.
 *
 * <p>This describes which class and what it may ask for by name; the class itself is loaded only
 * where the model runs.
 *
 * @param name name in the model file
 * @param className fully qualified name of the class
 * @param points every point of the model file, so that the class can ask for them
 * @param origin where it was written down
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
}
