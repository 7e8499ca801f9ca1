/**
 * Expressions of time, parameters and the state, for forces, prescribed motions, couplings, events
 * and outputs.
 *
 * <p>An {@link org.mechservice.solver.expression.Expression} is an immutable tree of few kinds of
 * nodes, in SI units, with every name resolved to an index: what the user has written. {@link
 * org.mechservice.solver.expression.Formulas} turns it into scalars of the graph of {@link
 * org.mechservice.solver.symbol}, for generated code and for evaluation alike. Leaves refer to a
 * mechanism through {@link org.mechservice.solver.expression.Coordinate} and {@link
 * org.mechservice.solver.expression.BodyPoint}, which are in this package so that descriptions of
 * joints may contain expressions.
 *
 * <p>{@link org.mechservice.solver.expression.FormulaEvaluation} evaluates formulas, their
 * gradients and their derivatives along a trajectory without allocation, as programs of the graph.
 * {@link org.mechservice.solver.expression.Tape} is the list of operations whose bounds over a step
 * {@link org.mechservice.solver.expression.TapePieces} finds.
 */
package org.mechservice.solver.expression;
