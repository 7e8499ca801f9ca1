package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.Drives;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;

/** Position, velocity, acceleration and power of every driven coordinate. */
final class DriveColumns implements ColumnValues {
  private final Drives drives;
  private final List<Variable> columns = new ArrayList<>();

  DriveColumns(EquationsOfMotion equations) {
    drives = new Drives(equations);
    for (int i = 0; i < drives.count(); i++) {
      columns.addAll(drives.positions(i));
      columns.add(drives.velocity(i));
      columns.add(drives.acceleration(i));
      columns.add(drives.power(i));
    }
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    drives.evaluate(t);
    int next = at;
    for (int i = 0; i < drives.count(); i++) {
      for (int k = 0; k < drives.positionCount(i); k++) {
        values[next++] = drives.positionOf(i, k);
      }
      values[next++] = drives.velocityOf(i);
      values[next++] = drives.accelerationOf(i);
      values[next++] = drives.forceOf(i) * drives.velocityOf(i);
    }
  }
}
