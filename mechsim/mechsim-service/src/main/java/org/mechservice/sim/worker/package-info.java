/**
 * Runs of models with classes of users, each in a process of its own: what such a class does wrong
 * ends its process and nothing else.
 *
 * <p>The host's side is {@link org.mechservice.sim.worker.WorkerProcess}, the worker's {@link
 * org.mechservice.sim.worker.WorkerMain}. They speak over the worker's standard input and output;
 * the host believes nothing it reads without checking it.
 */
@NullMarked
package org.mechservice.sim.worker;

import org.jspecify.annotations.NullMarked;
