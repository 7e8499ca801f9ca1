package org.mechservice.mechml.resolve.formula;

import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.solver.expression.Expression;

/** A value that formulas refer to by name besides coordinates: a state of the model file. */
@FunctionalInterface
public interface Signal {
  /**
   * Returns the value in the units of formulas.
   *
   * @throws ExpressionException if it depends on itself
   */
  Expression value() throws ExpressionException;
}
