package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Origin;

/** Something that acts on the bodies or joints of a mechanism. Gravity is not among them. */
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

  /** Returns where it was written down. */
  Origin origin();

  /**
   * Returns the values it can put out, with their names after the force's ({@code length} for the
   * column {@code f1.length}) and their SI units. A user force declares its own, so its list is
   * empty here.
   *
   * @param jointOf joint of a coordinate, tree or cut, as {@code Mechanism.jointOf} gives it
   */
  List<Variable> values(Function<Coordinate, Joint> jointOf);
}
