package org.mechservice.sim.build.dynamics;

import java.util.List;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Parameter;

/** Formulas of time and parameters as scalars; parameters are folded at their values. */
final class TimeFunctions extends Formulas {
  private final Expressions expressions;
  private final List<Parameter> parameters;

  TimeFunctions(Expressions expressions, List<Parameter> parameters) {
    super(expressions);
    this.expressions = expressions;
    this.parameters = parameters;
  }

  @Override
  Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.Time) {
      return expressions.input(Program.TIME);
    } else if (leaf instanceof Expression.ParameterValue parameter) {
      return expressions.constant(parameters.get(parameter.index()).value());
    }
    throw new IllegalArgumentException("a prescribed motion depends on " + leaf);
  }
}
