package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.Drives;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;

/** Values of the applied forces, then the driving forces, those of tree joints first. */
final class ForceColumns implements ColumnValues {
  private final EquationsOfMotion equations;
  private final Drives drives;
  private final List<Variable> columns = new ArrayList<>();
  private final int applied;

  ForceColumns(EquationsOfMotion equations) {
    this.equations = equations;
    drives = new Drives(equations);
    columns.addAll(equations.forces.columns());
    applied = columns.size();
    for (int i = 0; i < drives.count(); i++) {
      columns.add(drives.force(i));
    }
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    equations.forces.values(values, at);
    for (int i = 0; i < drives.count(); i++) {
      values[at + applied + i] = drives.forceOf(i);
    }
  }
}
