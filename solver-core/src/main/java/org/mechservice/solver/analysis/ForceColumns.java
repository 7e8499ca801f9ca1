package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/** Values of the applied forces, and the forces that driven joints of the tree take. */
final class ForceColumns implements ColumnValues {
  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();
  private final int applied;

  ForceColumns(EquationsOfMotion equations) {
    this.equations = equations;
    columns.addAll(equations.forces.columns());
    applied = columns.size();
    Mechanism mechanism = equations.tree.mechanism();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        addDrive(mechanism.joints().get(j), columns);
      }
    }
  }

  /** Adds the columns of the forces in a joint's coordinates. */
  static void addDrive(Joint joint, List<Variable> columns) {
    JointType type = joint.type();
    int count = type.velocityCount();
    for (int i = 0; i < count; i++) {
      String unit = type.velocityUnit(i).startsWith("rad") ? "N·m" : "N";
      columns.add(new Variable(joint.name() + ".drive" + (count == 1 ? "" : "[" + i + "]"), unit));
    }
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    equations.forces.values(values, at);
    System.arraycopy(
        equations.residual, equations.nv, values, at + applied, columns.size() - applied);
  }
}
