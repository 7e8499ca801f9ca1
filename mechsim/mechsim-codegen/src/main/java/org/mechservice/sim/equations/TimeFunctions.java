package org.mechservice.sim.equations;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.solver.expression.Expression;

/** Formulas of time and parameters as scalars; parameters are inputs. */
final class TimeFunctions extends Formulas {
  TimeFunctions(Expressions expressions) {
    super(expressions);
  }

  @Override
  Scalar leaf(Expression leaf) {
    throw new IllegalArgumentException("a prescribed motion depends on " + leaf);
  }
}
