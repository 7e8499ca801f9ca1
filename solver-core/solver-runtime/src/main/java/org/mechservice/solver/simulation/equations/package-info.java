/**
 * The equations of a model in the form that an integrator needs.
 *
 * <p>An {@link org.mechservice.solver.simulation.equations.EquationForm} makes {@link
 * org.mechservice.solver.simulation.equations.ModelEquations} of a model: {@code ExplicitForm}
 * those of open chains, y' = f(t, y); {@code ExplicitLoopForm} those of closed loops, whose states
 * are completed or projected; {@code ResidualForm} F(t, y, y') = 0 for ode15sR. {@code WatchedForm}
 * adds the events of a model to any of them. A standalone JAR contains only the classes that its
 * main class reaches, so each form is a class of its own: a scene without events or loops carries
 * no code for them.
 *
 * <p>{@link org.mechservice.solver.simulation.equations.RunEvents} gives a run the facts about
 * events: rows at them, the energy that they add, notes for the report, and the failure of an event
 * whose action is impossible. {@code WatchedRun} implements it for a model with events.
 *
 * <p>{@code solver.simulation} runs these equations from start to end.
 */
package org.mechservice.solver.simulation.equations;
