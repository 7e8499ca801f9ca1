/**
 * Closed loops: the loop equations with their derivatives, and the terms of a generated model with
 * loops.
 *
 * <p>{@link org.mechservice.sim.equations.loop.LoopCode} is the main type. It records the programs
 * that a class of loop terms consists of, laid out as {@link
 * org.mechservice.solver.closure.equations.LoopTerms} says; the solver closes the loops with them.
 * Whatever is zero in every state is not put out.
 *
 * <p>{@link org.mechservice.sim.equations.loop.LoopRows} derives the equations Φ(q, t) = 0 of all
 * loop closures, in the order of {@link org.mechservice.solver.closure.equations.LoopEquations}.
 * One {@link org.mechservice.sim.equations.loop.LoopRow} holds Φ, its rate, its row of the Jacobian
 * J and γ, which is Φ'' while no joint accelerates. {@code RelationRow} does the same for a
 * relation between positions of joints.
 *
 * <p>Depends on {@code links}, {@code kinematics}, {@code recursion}, {@code coordinates} and
 * {@code force}. The mathematics is in NUMERICS §3.
 */
@NullMarked
package org.mechservice.sim.equations.loop;

import org.jspecify.annotations.NullMarked;
