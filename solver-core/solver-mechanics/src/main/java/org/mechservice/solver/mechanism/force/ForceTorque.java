package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A force at a point of a body and a torque on the body, given by expressions. They are external
 * loads without a reaction on the mechanism and without potential energy.
 *
 * @param name name in the model file
 * @param point point of application
 * @param axes axes of the components
 * @param components three of the force, N, then three of the torque, N·m; of t, parameters and the
 *     state
 * @param origin position in the model file
 */
public record ForceTorque(
    String name, BodyPoint point, Axes axes, List<Expression> components, Origin origin)
    implements ForceElement {
  private static final List<Variable> COMPONENTS =
      List.of(
          new Variable("fx", "N"),
          new Variable("fy", "N"),
          new Variable("fz", "N"),
          new Variable("tx", "N·m"),
          new Variable("ty", "N·m"),
          new Variable("tz", "N·m"));

  /** Axes of the components. */
  public enum Axes {
    /** World axes. */
    WORLD,
    /** Axes fixed in the body. */
    BODY
  }

  public ForceTorque {
    components = List.copyOf(components);
    if (components.size() != 6) {
      throw new IllegalArgumentException(
          "force " + name + " needs 6 components, not " + components.size());
    }
  }

  /** {@inheritDoc} Components in the axes of the expressions. */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return COMPONENTS;
  }

  @Override
  public String kind() {
    return "force and torque";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.forceTorque(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(point.body());
  }

  @Override
  public List<Formula> formulas() {
    return IntStream.range(0, COMPONENTS.size())
        .mapToObj(i -> new Formula(COMPONENTS.get(i).name(), components.get(i)))
        .toList();
  }
}
