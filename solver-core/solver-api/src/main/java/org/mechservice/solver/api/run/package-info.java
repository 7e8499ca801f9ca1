/**
 * One run of a model: what is asked of it, how it is steered, and what is reported of it.
 *
 * <p>{@link RunRequest} says which interval is computed with which {@link RunSettings}:
 * formulation, closure, integrator and tolerances. {@link RunControl} lets other threads watch the
 * run, pause it, change its output step and stop it. {@link Checkpoints} keeps what is needed to
 * take it up again.
 *
 * <p>{@link RunReport} is the result beside the rows: the {@link Outcome}, the {@link Failure} if
 * there was one, counts, times, and the {@link RunNotes} with everything that a reader of the rows
 * should know. The same report is printed, stored beside results, and returned by the service.
 *
 * <p>The package depends on {@code solver.catalogue}, {@code solver.api} and {@code
 * solver.api.result}.
 */
package org.mechservice.solver.api.run;
