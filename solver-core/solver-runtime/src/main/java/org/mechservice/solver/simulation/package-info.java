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
 * <p>Package {@code equations} presents a model and its events to an integrator. The classes here
 * write rows and checkpoints, monitor energy and motion, collect notes and warnings, and word the
 * failures of a run.
 *
 * <p>The package depends on {@code solver.api}, {@code solver.ode} and the mechanics of the model.
 */
package org.mechservice.solver.simulation;
