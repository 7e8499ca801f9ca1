/**
 * Runs of models with classes of users, each in a process of its own, so that a fault of such a
 * class ends its process and nothing else.
 *
 * <p>{@link org.mechservice.sim.worker.WorkerProcess} is the host's side: it starts the process
 * with bounded memory, sends it a {@link org.mechservice.sim.worker.WorkerOrder} and reads rows,
 * progress and the {@link org.mechservice.sim.worker.WorkerResult}. {@link
 * org.mechservice.sim.worker.WorkerMain} is the main class of the process. Both use the standard
 * input and output of the process; the host checks every value that it reads. {@link
 * org.mechservice.sim.worker.WorkerLostException} reports a process that has ended without a
 * result.
 *
 * <p>{@link org.mechservice.sim.worker.Confinement} is the wall of the operating system around the
 * process: bubblewrap, which shows it the {@code JavaFiles} alone, and a {@code SystemCallFilter}.
 * A wall counts only after {@code ConfinementProbe} has tried in vain to get out of it. {@link
 * org.mechservice.sim.worker.UserCodePolicy} says what happens without one, and {@link
 * org.mechservice.sim.worker.WorkerBounds} what the process may use.
 *
 * <p>Depends on mechsim-codegen and the solver, on no package of the service.
 */
@NullMarked
package org.mechservice.sim.worker;

import org.jspecify.annotations.NullMarked;
