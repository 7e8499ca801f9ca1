package org.mechservice.mechml.resolve.formula;

import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.solver.expression.Expression;

/**
 * A value that formulas refer to by name besides coordinates: a state of the model file, or the
 * output of a block of states.
 */
@FunctionalInterface
public interface Signal {
  /**
   * Returns the value in the units of formulas.
   *
   * @param offset of its name in the formula that refers to it, for messages
   * @throws ExpressionException if it depends on itself
   */
  Expression value(int offset) throws ExpressionException;
}
