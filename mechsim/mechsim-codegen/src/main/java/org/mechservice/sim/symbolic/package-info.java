/**
 * Symbolic numbers: arithmetic that is recorded instead of computed.
 *
 * <p>{@link org.mechservice.sim.symbolic.Scalar} has the arithmetic of a number but records it in
 * an {@link org.mechservice.sim.symbolic.Expressions} graph: equal expressions are one node,
 * constants are folded, and terms that are zero disappear ({@code Simplification}). {@link
 * org.mechservice.sim.symbolic.ScalarVector} and {@link org.mechservice.sim.symbolic.ScalarMatrix}
 * are vectors and matrices of three such numbers a side. {@link
 * org.mechservice.sim.symbolic.Differentiation} along a direction, {@link
 * org.mechservice.sim.symbolic.ReverseDifferentiation} by all inputs at once and {@link
 * org.mechservice.sim.symbolic.Substitution} make new expressions from old ones.
 *
 * <p>Mechanics written over scalars are recorded as a {@link org.mechservice.sim.symbolic.Program}:
 * outputs in sections, with guards. A program is printed as source or byte code, or evaluated in
 * doubles.
 *
 * <p>Nodes are numbered in the order of their creation, and nothing depends on hash order: the same
 * mechanics over the same numbers gives the same program, operation by operation.
 */
@NullMarked
package org.mechservice.sim.symbolic;

import org.jspecify.annotations.NullMarked;
