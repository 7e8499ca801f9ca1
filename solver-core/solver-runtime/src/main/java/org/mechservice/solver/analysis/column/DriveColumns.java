package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.Drives;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;

/** Position, velocity, acceleration and power of every driven coordinate. */
final class DriveColumns implements ColumnValues {
  private static final int PER_COORDINATE = 4;

  private final Drives drives;
  private final List<Variable> columns = new ArrayList<>();

  DriveColumns(EquationsOfMotion equations) {
    drives = new Drives(equations);
    for (int i = 0; i < drives.count(); i++) {
      columns.add(drives.position(i));
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
    for (int i = 0; i < drives.count(); i++) {
      int first = at + PER_COORDINATE * i;
      values[first] = drives.positionOf(i);
      values[first + 1] = drives.velocityOf(i);
      values[first + 2] = drives.accelerationOf(i);
      values[first + 3] = drives.forceOf(i) * drives.velocityOf(i);
    }
  }
}
