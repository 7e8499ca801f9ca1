/**
 * Closed loops: the loop equations with their derivatives, and the terms of a generated model with
 * loops.
 *
 * <p>{@link org.mechservice.sim.equations.loop.LoopCode} is the main type. It records the programs
 * of a class of loop terms, in the layout of {@link
 * org.mechservice.solver.closure.equations.LoopTerms}; the solver closes the loops with them.
 * Elements that are zero in every state are not output.
 *
 * <p>{@link org.mechservice.sim.equations.loop.LoopRows} derives the equations Φ(q, t) = 0 of all
 * loop closures, in the order of {@link org.mechservice.solver.closure.equations.LoopEquations}.
 * One {@link org.mechservice.sim.equations.loop.LoopRow} holds Φ, its rate, its row of the Jacobian
 * J and γ, which is Φ'' with zero joint accelerations. {@code RelationRow} derives the row of a
 * coupling of joint positions.
 *
 * <p>Depends on {@code links}, {@code kinematics}, {@code recursion}, {@code coordinates} and
 * {@code force}. The mathematics is in docs/theory/loops.md.
 */
@NullMarked
package org.mechservice.sim.equations.loop;

import org.jspecify.annotations.NullMarked;
