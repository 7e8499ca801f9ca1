package org.mechservice.solver.analysis.column;

import java.util.List;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.force.formula.ExpressionInputs;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Output;

/** User-defined outputs, evaluated from expressions. */
final class OutputColumns implements ColumnValues {
  private final List<Variable> columns;
  private final ExpressionInputs expressions;

  OutputColumns(TreeMotion motion, List<Output> outputs) {
    columns = outputs.stream().map(output -> new Variable(output.name(), output.unit())).toList();
    expressions = new ExpressionInputs(motion, outputs.stream().map(Output::value).toList());
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    expressions.evaluate(t);
    expressions.accepted();
    for (int i = 0; i < columns.size(); i++) {
      values[at + i] = expressions.value(i);
    }
  }
}
