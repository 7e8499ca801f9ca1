package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.closure.equations.LoopEquations;

/**
 * Residuals of the loops and the forces that close them. A tilt is multiplied by the mechanism's
 * length, so that all residuals are in m. The forces of an equation are −λ times its gradient: a
 * rod in tension has a positive multiplier.
 */
final class ConstraintColumns implements ColumnValues {
  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();

  ConstraintColumns(EquationsOfMotion equations) {
    this.equations = equations;
    LoopEquations loops = equations.loops;
    if (loops.count() > 0) {
      columns.add(new Variable("constraint.position", "m"));
      columns.add(new Variable("constraint.velocity", "m/s"));
    }
    for (int row = 0; row < loops.count(); row++) {
      int first = row;
      while (first > 0 && loops.closure(first - 1) == loops.closure(row)) {
        first--;
      }
      boolean single =
          first == row
              && (row + 1 == loops.count() || loops.closure(row + 1) != loops.closure(row));
      String index = single ? "" : "[" + (row - first) + "]";
      columns.add(new Variable(loops.closure(row).name() + ".lambda" + index, unit(loops, row)));
    }
  }

  private static String unit(LoopEquations loops, int row) {
    return switch (loops.unit(row)) {
      case "m" -> "N";
      case "rad" -> "N·m";
      default -> loops.unit(row);
    };
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    LoopEquations loops = equations.loops;
    if (loops.count() == 0) {
      return;
    }
    double position = 0;
    double velocity = 0;
    for (int row = 0; row < loops.count(); row++) {
      position = Math.max(position, Math.abs(loops.value[row]) / loops.size(row));
      velocity = Math.max(velocity, Math.abs(loops.rate[row]) / loops.size(row));
    }
    values[at] = position * loops.length();
    values[at + 1] = velocity * loops.length();
    System.arraycopy(equations.lambda, 0, values, at + 2, loops.count());
  }
}
