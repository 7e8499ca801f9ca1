package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/** Names and units of the output columns of forces, and of the driving forces of driven joints. */
final class ForceColumnNames {
  private ForceColumnNames() {}

  static List<Variable> of(Mechanism mechanism) {
    List<Variable> columns = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      for (Variable value : force.values(mechanism::jointOf)) {
        columns.add(new Variable(force.name() + "." + value.name(), value.unit()));
      }
    }
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        addDriving(mechanism.joints().get(j), columns);
      }
    }
    return columns;
  }

  private static void addDriving(Joint joint, List<Variable> columns) {
    int count = joint.type().velocityCount();
    for (int i = 0; i < count; i++) {
      String name = joint.name() + ".drive" + (count == 1 ? "" : "[" + i + "]");
      columns.add(new Variable(name, joint.forceUnit(i)));
    }
  }
}
