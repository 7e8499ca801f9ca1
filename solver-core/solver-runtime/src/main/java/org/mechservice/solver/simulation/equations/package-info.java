/**
 * The equations of a model as an integrator takes them.
 *
 * <p>An {@link org.mechservice.solver.simulation.equations.EquationForm} makes {@link
 * org.mechservice.solver.simulation.equations.ModelEquations} of a model: {@code ExplicitForm}
 * those of open chains, y' = f(t, y); {@code ExplicitLoopForm} those of closed loops, whose states
 * are completed or projected; {@code ResidualForm} F(t, y, y') = 0 for ode15sR. {@code WatchedForm}
 * adds the events of a model to any of them. A standalone JAR contains only the classes that its
 * main class reaches, so each form is a class of its own: a scene without events or loops carries
 * no code for them.
 *
 * <p>{@link org.mechservice.solver.simulation.equations.RunEvents} is what a run asks about events:
 * rows that fall due at them, the energy they put in, notes for the report, and the failure of an
 * event that cannot do what the model says. {@code WatchedRun} answers for a model with events.
 *
 * <p>{@code solver.simulation} runs these equations from start to end.
 */
package org.mechservice.solver.simulation.equations;
