package org.mechservice.sim.equations.kinematics;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/** Formulas of time and parameters as scalars; parameters are inputs. */
public final class TimeFunctions extends Formulas {
  public TimeFunctions(Expressions expressions) {
    super(expressions);
  }

  @Override
  protected Scalar leaf(Expression leaf) {
    throw new IllegalArgumentException("a prescribed motion depends on " + leaf);
  }
}
