package org.mechservice.solver.expression;

import java.util.List;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.Expression.Time;

/** First and second derivatives of a table or map by its arguments. */
final class TableSlopes {
  double byA;
  double byB;
  double byAA;
  double byAB;
  double byBB;
  private final FormulaEvaluation evaluation;
  private final int count;

  TableSlopes(PointFunction table) {
    count = table.argumentCount();
    List<Expression> arguments = List.of(new Argument(), new Time());
    Expression value = new TableValue(table, arguments.subList(0, count));
    evaluation = new FormulaEvaluation(List.of(value));
  }

  /** Evaluates them; of one argument the second is ignored. */
  void evaluate(double a, double b) {
    int first = evaluation.leaves().indexOf(new Argument());
    int last = count - 1 - first;
    double[] by = new double[count];
    double[] direction = new double[count];
    evaluation.setLeaf(last, b);
    evaluation.setLeaf(first, a);
    evaluation.derivatives();
    evaluation.gradient(0, by);
    byA = by[first];
    byB = by[last];
    direction[first] = 1;
    evaluation.gradientChange(0, direction, by);
    byAA = by[first];
    byAB = by[last];
    direction[first] = 0;
    direction[last] = 1;
    evaluation.gradientChange(0, direction, by);
    byBB = by[last];
  }
}
