/**
 * Expressions of time, parameters and the state, for forces, prescribed motions, couplings, events
 * and outputs.
 *
 * <p>An {@link org.mechservice.solver.expression.Expression} is an immutable tree of few kinds of
 * nodes, in SI units, with every name resolved to an index. The interface is sealed, so the
 * compiler checks that every switch over the kinds of nodes (in the tape compiler, in the code
 * generator) is complete. Leaves refer to a mechanism through {@link
 * org.mechservice.solver.expression.Coordinate} and {@link
 * org.mechservice.solver.expression.BodyPoint}, which are in this package so that descriptions of
 * joints may contain expressions.
 *
 * <p>{@link org.mechservice.solver.expression.Tape} compiles expressions to a list of operations
 * with common subexpressions shared; {@link org.mechservice.solver.expression.TapeEvaluation} runs
 * it and computes values, gradients (reverse mode) and derivatives along a trajectory (forward
 * mode) without allocation. The functions, with their values and derivatives, are those of the
 * catalogue {@link org.mechservice.solver.symbol.MathFunction}. Source: Griewank and Walther,
 * <i>Evaluating Derivatives</i>, 2008, chapter 3.
 */
package org.mechservice.solver.expression;
