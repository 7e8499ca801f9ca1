/**
 * A search for jumps, pulses and poles of a right-hand side of which only values are known.
 *
 * <p>{@link UndeclaredJumps} is a watch of the steps that is put around any integrator on request;
 * integrators contain nothing of it.
 *
 * <p>A jump shows by failing error tests. {@link JumpSearch} then narrows it down by shorter steps
 * until the jump lies between two neighbouring places; {@link JumpMonitor} recognises it in an
 * implicit method by the way in which the tests fail, {@link UnforeseenJump} in a step that passes,
 * {@link SteepColumns} in a column of a Jacobian by differences. {@link SlidingMonitor} recognises
 * a solution that slides along a jump, as a block with dry friction at rest does (a sliding mode of
 * Filippov), by equations that cannot be solved, {@link ChatterMonitor} by steps of which many are
 * rejected. {@link JumpProbe} looks a little ahead whether f jumps or is only steep. {@link
 * PoleProbe} looks whether a step goes across a place where f grows beyond every bound, {@link
 * PulseProbe} whether a long straight step has two jumps inside that cancel.
 *
 * <p>The package depends on {@code ode}, {@code ode.step}, {@code ode.newton} and {@code linear};
 * no method depends on it. Source: E. Hairer, S. P. Nørsett and G. Wanner, <i>Solving Ordinary
 * Differential Equations I</i>, II.6; A. F. Filippov, <i>Differential Equations with Discontinuous
 * Righthand Sides</i>, 1988.
 */
package org.mechservice.solver.ode.jumps;
