/**
 * Runs of models whose classes come from elsewhere, each in a process of its own, so that a fault
 * of such a class ends its process and nothing else.
 *
 * <p>{@link org.mechservice.guard.worker.WorkerProcess} is the side of the host, or of the client
 * that runs a model which a server has generated: it starts the process with bounded memory, sends
 * it a {@link org.mechservice.guard.worker.WorkerModel}, may ask for its {@link
 * org.mechservice.guard.worker.WorkerDescription}, sends a {@link
 * org.mechservice.guard.worker.WorkerOrder} and reads rows, progress and the {@link
 * org.mechservice.guard.worker.WorkerResult}. {@link org.mechservice.guard.worker.WorkerMain} is
 * the main class of the process. Both use the standard input and output of the process; every value
 * that comes from it is checked. {@link org.mechservice.guard.worker.WorkerLostException} reports a
 * process that has ended without a result.
 *
 * <p>The wall around the process is that of the package above, on which this one depends, and on
 * the solver.
 */
@NullMarked
package org.mechservice.guard.worker;

import org.jspecify.annotations.NullMarked;
