/**
 * One run of a model: its request and settings, its control, its checkpoints and its report.
 *
 * <p>{@link RunRequest} holds the {@link RunSettings} (interval, output step, integrator and
 * tolerances), the requested columns and the conditions that end the run early. {@link RunControl}
 * lets other threads monitor the run, pause it, continue it step by step and stop it. {@link
 * Checkpoints} stores the data from which a run can be resumed.
 *
 * <p>{@link RunReport} is the result in addition to the rows: the {@link Outcome}, the {@link
 * Failure} if there was one, counts, times, and the {@link RunNotes}, the remarks on the validity
 * of the rows. The same report is printed, stored beside results, and returned by the service.
 *
 * <p>The package depends on {@code solver.catalogue}, {@code solver.api} and {@code
 * solver.api.result}.
 */
package org.mechservice.solver.api.run;
