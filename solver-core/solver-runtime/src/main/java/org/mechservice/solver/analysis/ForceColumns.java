package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;

/**
 * Values of the applied forces, and the forces that driven joints take, those of the tree first.
 */
final class ForceColumns implements ColumnValues {
  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();
  private final int applied;

  /** Equations of prescribed motions of cut joints, whose multipliers are the drives' opposites. */
  private final List<Integer> cutDrives = new ArrayList<>();

  ForceColumns(EquationsOfMotion equations) {
    this.equations = equations;
    columns.addAll(equations.forces.columns());
    applied = columns.size();
    Mechanism mechanism = equations.tree.mechanism();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        addDrive(mechanism.joints().get(j));
      }
    }
    LoopEquations loops = equations.loops;
    for (int row = 0; row < loops.count(); row++) {
      boolean last = row + 1 == loops.count() || loops.closure(row + 1) != loops.closure(row);
      if (last && loops.closure(row) instanceof JointClosure cut && cut.isDriven()) {
        addDrive(cut.joint());
        for (int i = cut.motion().size() - 1; i >= 0; i--) {
          cutDrives.add(row - i);
        }
      }
    }
  }

  /** Adds the columns of the forces in a joint's coordinates. */
  private void addDrive(Joint joint) {
    JointType type = joint.type();
    int count = type.velocityCount();
    for (int i = 0; i < count; i++) {
      columns.add(
          new Variable(
              joint.name() + ".drive" + (count == 1 ? "" : "[" + i + "]"), joint.forceUnit(i)));
    }
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    equations.forces.values(values, at);
    int inTree = equations.tree.velocityCount - equations.nv;
    System.arraycopy(equations.residual, equations.nv, values, at + applied, inTree);
    for (int i = 0; i < cutDrives.size(); i++) {
      values[at + applied + inTree + i] = 0 - equations.lambda[cutDrives.get(i)];
    }
  }
}
