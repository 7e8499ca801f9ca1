/**
 * Running a model from the start time to the end time.
 *
 * <p>{@link org.mechservice.solver.simulation.Simulation} performs one run: it starts the
 * integrator, writes a row at each requested output time, monitors the energy balance, obeys
 * control from outside and returns a report. {@link
 * org.mechservice.solver.simulation.RuntimeSolver} is the solver of the runtime JAR, which holds
 * every integrator and selects the one that a run names; {@link
 * org.mechservice.solver.simulation.AnalysisSolver} serves the analyses, which compute each state
 * without integration.
 *
 * <p>The forms of the equations ({@link org.mechservice.solver.simulation.ExplicitForm}, {@link
 * org.mechservice.solver.simulation.ResidualForm} and their variants) present a model to an
 * integrator. A standalone JAR contains only the classes that its main class reaches, so each form
 * is a class of its own: a scene without events or loops carries no code for them.
 *
 * <p>The remaining classes write rows and checkpoints, collect notes and warnings, and word the
 * failures of a run.
 *
 * <p>The package depends on {@code solver.api}, {@code solver.ode} and the mechanics of the model.
 */
package org.mechservice.solver.simulation;
