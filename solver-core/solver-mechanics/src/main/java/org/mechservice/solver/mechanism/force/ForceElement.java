package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Origin;

/** An applied force on the bodies or joints of a mechanism. Gravity is not a force element. */
public sealed interface ForceElement
    permits SpringDamper,
        JointSpringDamper,
        Bushing,
        ForceTorque,
        JointForce,
        Contact,
        JointFriction,
        UserForceElement {
  /** Returns the name in the model file. */
  String name();

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
