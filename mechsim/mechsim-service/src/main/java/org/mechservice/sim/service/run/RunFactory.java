package org.mechservice.sim.service.run;

import org.mechservice.guard.WorkerBounds;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.model.ModelClasses;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.Simulation;

/** Makes simulations that a host's queue runs. */
public final class RunFactory {
  private final Solver solver;
  private final RunQueue queue;
  private final RunStore store;

  public RunFactory(Solver solver, RunQueue queue, RunStore store) {
    this.solver = solver;
    this.queue = queue;
    this.store = store;
  }

  /**
   * Returns the columns of a run.
   *
   * @param task what computes it
   * @throws IllegalArgumentException if the model lacks a requested column group
   */
  public RunColumns columns(RunTask task, RunRequest request) {
    Model model = task.model();
    Simulation.requireBalance(model, request);
    return RunColumns.of(groups -> Simulation.columns(model, groups), request.columns())
        .with(task.columns());
  }

  /**
   * Makes the task of a run: computed in this process, or in a process of its own if the model has
   * classes of users.
   *
   * @param bounds what a process of its own may use at most
   */
  public RunTask task(ModelClasses compiled, RunRequest request, WorkerBounds bounds) {
    return compiled.hasUserClasses()
        ? new WorkerTask(compiled, request, bounds)
        : here(compiled, request);
  }

  private LocalTask here(ModelClasses compiled, RunRequest request) {
    ModelSource source = compiled.instances();
    Model model = source.model();
    return new LocalTask(
        solver,
        source,
        model,
        source.parameters(),
        request,
        new RunCheckpoints(compiled::sha256, Simulation.canBeSaved(model)),
        new LocalTask.ThreadClock());
  }

  /**
   * Makes a simulation.
   *
   * @param listener receives what happens to it
   * @throws LimitExceeded if its rows would be more than the host or its disk takes
   */
  public SimulationRun create(RunPlan plan, SimulationRun.Listener listener) throws LimitExceeded {
    requireRoomForRows(plan.identity().owner(), plan.task().settings(), plan.columns().count());
    return new SimulationRun(plan, queue, store, listener);
  }

  private void requireRoomForRows(String owner, RunSettings settings, int columns)
      throws LimitExceeded {
    double rows = (settings.tEnd() - settings.tStart()) / settings.tStep() + 2;
    store
        .account()
        .require(
            owner,
            rows * columns * Double.BYTES,
            "the run would put out "
                + (long) rows
                + " rows of "
                + columns
                + " columns, more than this host keeps; make t-step larger or choose fewer"
                + " columns");
  }
}
