/**
 * One simulation run: from its request through queue and solver to its end.
 *
 * <p>{@link org.mechservice.sim.service.run.RunFactory} makes a {@link
 * org.mechservice.sim.service.run.SimulationRun} from a {@link
 * org.mechservice.sim.service.run.RunPlan}; a {@link org.mechservice.sim.service.run.RunQueue}
 * gives it a thread. The run is put together from four parts: {@code RunLifecycle} is its state
 * machine, {@code RunOutput} takes its rows, {@code RunStatus} makes its progress, summary, report
 * and record, and {@code RunCompletion} ends it exactly once and stores its {@code RunOutcome}.
 *
 * <p>A {@link org.mechservice.sim.service.run.RunTask} computes: {@code LocalTask} in this process,
 * {@code WorkerTask} in a process of its own, for models with classes of users. {@code
 * RunCheckpoints} keeps the checkpoint that a run starts from and the latest it has made.
 *
 * <p>Depends on the packages {@code results}, {@code limits} and {@code contract}, on {@code
 * guard.worker} and on the solver; knows neither sessions nor requests.
 */
@NullMarked
package org.mechservice.sim.service.run;

import org.jspecify.annotations.NullMarked;
