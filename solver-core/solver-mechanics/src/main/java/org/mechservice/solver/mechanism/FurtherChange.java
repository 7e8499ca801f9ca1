package org.mechservice.solver.mechanism;

import org.mechservice.solver.expression.Expression;

/**
 * A new value of a further state.
 *
 * @param state index among the mechanism's further states
 * @param value expression of the previous state, in the state's own unit
 */
public record FurtherChange(int state, Expression value) {}
