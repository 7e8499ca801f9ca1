package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Origin;

/**
 * A force at a point of a body and a torque on the body, given by expressions. Nothing reacts: they
 * come from outside the mechanism. They have no energy.
 *
 * @param name name in the model file
 * @param point where the force acts
 * @param axes whose components the expressions give
 * @param components three of the force, N, then three of the torque, N·m; of t, parameters and the
 *     state
 * @param origin where it was written down
 */
public record ForceTorque(
    String name, BodyPoint point, Axes axes, List<Expression> components, Origin origin)
    implements ForceElement {

  /** Whose axes the components refer to. */
  public enum Axes {
    /** The world's. */
    WORLD,
    /** The body's, turning with it. */
    BODY
  }

  public ForceTorque {
    components = List.copyOf(components);
    if (components.size() != 6) {
      throw new IllegalArgumentException(
          "force " + name + " needs 6 components, not " + components.size());
    }
  }

  /** {@inheritDoc} Components in the axes the expressions are given in. */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("fx", "N"),
        new Variable("fy", "N"),
        new Variable("fz", "N"),
        new Variable("tx", "N·m"),
        new Variable("ty", "N·m"),
        new Variable("tz", "N·m"));
  }
}
