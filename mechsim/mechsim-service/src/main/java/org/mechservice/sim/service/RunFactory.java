package org.mechservice.sim.service;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.simulation.Simulation;

/** Makes simulations that a host's queue runs. */
final class RunFactory {
  private final Solver solver;
  private final RunQueue queue;
  private final RunStore store;
  private final Path disk;

  /**
   * @param disk where the rows go
   */
  RunFactory(Solver solver, RunQueue queue, RunStore store, Path disk) {
    this.solver = solver;
    this.queue = queue;
    this.store = store;
    this.disk = disk;
  }

  /**
   * Returns the columns of a run.
   *
   * @throws IllegalArgumentException if the model has not what is asked for
   */
  RunColumns columns(Model model, RunRequest request) {
    Simulation.requireBalance(model, request);
    return RunColumns.of(groups -> Simulation.columns(model, groups), request.columns());
  }

  /**
   * Makes the computing of a run: here, or where the model has classes of users, in a process of
   * its own.
   *
   * @param memoryBytes most memory of a process of its own; negative: what Java takes by itself
   */
  RunTask task(CompiledModel compiled, RunRequest request, long memoryBytes) {
    return compiled.hasUserClasses()
        ? new WorkerRun(compiled, request, memoryBytes)
        : here(compiled, request);
  }

  private ModelRun here(CompiledModel compiled, RunRequest request) {
    ModelSource source = compiled.instances();
    Model model = source.model();
    return new ModelRun(
        solver,
        source,
        model,
        source.parameters(),
        request,
        new RunCheckpoints(compiled::sha256, Simulation.canBeSaved(model)),
        new ThreadClock());
  }

  /**
   * Makes a simulation.
   *
   * @param session whose it is
   * @param earlierIds of the runs that it goes on from
   * @throws LimitExceeded if its rows would be more than the host or its disk takes
   */
  SimulationRun create(
      RunTask task,
      RunColumns columns,
      LoadedModel source,
      RunFacts facts,
      Session session,
      List<String> earlierIds)
      throws LimitExceeded {
    requireRoomForRows(task.settings(), columns.count());
    RunIdentity identity =
        new RunIdentity(
            UUID.randomUUID().toString(),
            session.id(),
            session.host().hostName(),
            session.owner(),
            task.description().name(),
            source.fileName(),
            source.text(),
            System.currentTimeMillis(),
            earlierIds);
    RunPlan plan = new RunPlan(identity, task, columns, facts);
    return new SimulationRun(plan, queue, store, session);
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
