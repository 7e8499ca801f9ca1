package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/** An applied force on the bodies or joints of a mechanism. Gravity is not a force element. */
public sealed interface ForceElement
    permits SpringDamper,
        JointSpringDamper,
        Bushing,
        ForceTorque,
        JointForce,
        CouplingSpringDamper,
        PathForce,
        Contact,
        JointFriction,
        PairForce,
        LawForce,
        UserForceElement {
  /** Returns the name in the model file. */
  String name();

  /** Returns its kind in words, such as {@code spring between points}. */
  String kind();

  /** Returns the visitor's answer for this kind of force. */
  <R> R accept(ForceVisitor<R> visitor);

  /**
   * Returns the bodies at whose points it acts, the root among them; none of a force in a joint.
   */
  default List<Integer> bodies() {
    return List.of();
  }

  /** Returns the coordinate of the joint that it acts in, if it does. */
  default Optional<Coordinate> jointCoordinate() {
    return Optional.empty();
  }

  /** Returns the numbers of its law, in the order in which the law takes them. */
  default List<Coefficient> coefficients() {
    return List.of();
  }

  /** Returns the formulas of time and state that give its components. */
  default List<Formula> formulas() {
    return List.of();
  }

  /**
   * A component given by a formula.
   *
   * @param quantity its name in messages
   * @param expression of t, parameters and the state
   */
  record Formula(String quantity, Expression expression) {}

  /** Returns its position in the model file. */
  Origin origin();

  /**
   * Returns its output values, with their names after the force's name ({@code length} for the
   * column {@code f1.length}) and their SI units. A user force declares its own, so its list is
   * empty here.
   *
   * @param jointOf joint of a coordinate, tree or cut, as {@code Mechanism.jointOf} gives it
   */
  List<Variable> values(Function<Coordinate, Joint> jointOf);
}
