/**
 * Expressions of time, parameters and the state: what forces, prescribed motions, couplings, events
 * and outputs are written in.
 *
 * <p>An {@link org.mechservice.solver.expression.Expression} is an immutable tree of few kinds of
 * nodes, in SI units, with every name resolved to an index; whoever reads one (a compiler to a
 * tape, a generator of code) switches over the kinds and can forget none. Its leaves look at a
 * mechanism through {@link org.mechservice.solver.expression.Coordinate} and {@link
 * org.mechservice.solver.expression.BodyPoint}, which live here so that descriptions of joints may
 * themselves contain expressions.
 */
package org.mechservice.solver.expression;
