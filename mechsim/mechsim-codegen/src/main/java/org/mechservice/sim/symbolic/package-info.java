/**
 * Numbers that are known only when a model runs.
 *
 * <p>{@link org.mechservice.sim.symbolic.Scalar} has the arithmetic of a number but records it in
 * an {@link org.mechservice.sim.symbolic.Expressions} graph: equal expressions are one node,
 * constants are folded, what is zero disappears. Mechanics written once over it becomes a {@link
 * org.mechservice.sim.symbolic.Program}, which is printed as source or evaluated in doubles.
 *
 * <p>Nodes are numbered in the order in which they arise and nothing depends on hash order: the
 * same mechanics over the same numbers gives the same program, operation by operation.
 */
@NullMarked
package org.mechservice.sim.symbolic;

import org.jspecify.annotations.NullMarked;
