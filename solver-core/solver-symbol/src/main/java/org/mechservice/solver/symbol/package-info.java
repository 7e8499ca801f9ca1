/**
 * Symbolic numbers: arithmetic that is recorded instead of computed.
 *
 * <p>{@link org.mechservice.solver.symbol.Scalar} has the arithmetic of a number but records it in
 * an {@link org.mechservice.solver.symbol.Expressions} graph: equal expressions are one node,
 * constants are folded, and terms that are zero disappear ({@code Simplification}). {@link
 * org.mechservice.solver.symbol.ScalarVector} and {@link
 * org.mechservice.solver.symbol.ScalarMatrix} are vectors and matrices of three such numbers a
 * side. {@link org.mechservice.solver.symbol.Differentiation} along a direction, {@link
 * org.mechservice.solver.symbol.ReverseDifferentiation} by all inputs at once and {@link
 * org.mechservice.solver.symbol.Substitution} make new expressions from old ones.
 *
 * <p>{@link org.mechservice.solver.symbol.MathFunction} is the catalogue of functions: value,
 * slopes, rule of units, bounds, corners and jumps, and what generated Java and C call.
 *
 * <p>Mechanics written over scalars are recorded as a {@link
 * org.mechservice.solver.symbol.Program}: outputs in sections, with guards. A program is printed as
 * source or byte code, or evaluated in doubles.
 *
 * <p>Nodes are numbered in the order of their creation, and nothing depends on hash order: the same
 * mechanics over the same numbers gives the same program, operation by operation.
 */
package org.mechservice.solver.symbol;
