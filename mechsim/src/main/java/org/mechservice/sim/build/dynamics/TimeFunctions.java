package org.mechservice.sim.build.dynamics;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.solver.expression.Expression;

/** Formulas of time and parameters as scalars; parameters are inputs. */
final class TimeFunctions extends Formulas {
  private final Expressions expressions;

  TimeFunctions(Expressions expressions) {
    super(expressions);
    this.expressions = expressions;
  }

  @Override
  Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.Time) {
      return expressions.input(Program.TIME);
    } else if (leaf instanceof Expression.ParameterValue parameter) {
      return expressions.input(Program.PARAMETER + parameter.index());
    }
    throw new IllegalArgumentException("a prescribed motion depends on " + leaf);
  }
}
