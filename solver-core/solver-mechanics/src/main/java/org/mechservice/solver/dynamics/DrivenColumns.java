package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** Output columns for the forces of driven joints. */
final class DrivenColumns {
  private final List<Variable> columns = new ArrayList<>();
  private final double[] force;
  private final int start;

  DrivenColumns(TreeGeometry tree) {
    Mechanism mechanism = tree.mechanism();
    start = tree.stateVelocityCount;
    force = new double[tree.velocityCount - start];
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        add(mechanism.joints().get(j));
      }
    }
  }

  private void add(Joint joint) {
    JointType type = joint.type();
    int count = type.velocityCount();
    for (int i = 0; i < count; i++) {
      columns.add(
          new Variable(
              joint.name() + ".drive" + (count == 1 ? "" : "[" + i + "]"), joint.forceUnit(i)));
    }
  }

  boolean isEmpty() {
    return columns.isEmpty();
  }

  /** Returns name and unit of each force, in the order of the extended velocities. */
  List<Variable> columns() {
    return columns;
  }

  /** Returns the array for the forces, N·m or N. */
  double[] forces() {
    return force;
  }

  /** Returns the power of the forces in {@link #forces}, W. */
  double power(TreeMotion motion) {
    double sum = 0;
    for (int i = 0; i < force.length; i++) {
      sum += force[i] * motion.v[start + i];
    }
    return sum;
  }
}
