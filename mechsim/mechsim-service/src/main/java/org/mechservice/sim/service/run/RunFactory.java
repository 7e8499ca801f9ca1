package org.mechservice.sim.service.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.sim.worker.WorkerBounds;
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
  private final Path disk;

  /**
   * @param disk where the rows go
   */
  public RunFactory(Solver solver, RunQueue queue, RunStore store, Path disk) {
    this.solver = solver;
    this.queue = queue;
    this.store = store;
    this.disk = disk;
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
  public RunTask task(CompiledModel compiled, RunRequest request, WorkerBounds bounds) {
    return compiled.hasUserClasses()
        ? new WorkerTask(compiled, request, bounds)
        : here(compiled, request);
  }

  private LocalTask here(CompiledModel compiled, RunRequest request) {
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
    requireRoomForRows(plan.task().settings(), plan.columns().count());
    return new SimulationRun(plan, queue, store, listener);
  }

  private void requireRoomForRows(RunSettings settings, int columns) throws LimitExceeded {
    double rows = (settings.tEnd() - settings.tStart()) / settings.tStep() + 2;
    store
        .account()
        .require(
            rows * columns * Double.BYTES,
            freeDisk(),
            "the run would put out "
                + (long) rows
                + " rows of "
                + columns
                + " columns, more than this host keeps; make t-step larger or choose fewer"
                + " columns");
  }

  private long freeDisk() {
    try {
      return Files.getFileStore(disk).getUsableSpace();
    } catch (IOException e) {
      return Long.MAX_VALUE; // not known: the run itself will find out
    }
  }
}
