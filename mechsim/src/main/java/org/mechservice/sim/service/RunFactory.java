package org.mechservice.sim.service;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.simulation.Simulation;

/** Makes simulations that a host's queue runs. */
final class RunFactory {
  private final Solver solver;
  private final RunQueue queue;
  private final HostLimits limits;

  RunFactory(Solver solver, RunQueue queue, HostLimits limits) {
    this.solver = solver;
    this.queue = queue;
    this.limits = limits;
  }

  /** Returns the columns of a run. */
  List<Variable> columns(Model model, RunRequest request) {
    if (model instanceof ExplicitModel explicit) {
      return Simulation.columns(explicit, request.columns());
    }
    throw new IllegalArgumentException(
        "S-061 model \"" + model.description().name() + "\" has no explicit form y' = f(t, y)");
  }

  /**
   * Makes a simulation.
   *
   * @throws LimitExceeded if its rows would be more than the host or its disk takes
   */
  SimulationRun create(
      Model model, RunRequest request, int columns, SimulationRun.Listener listener)
      throws LimitExceeded {
    requireRoomForRows(request.settings(), columns);
    return new SimulationRun(
        UUID.randomUUID().toString(), solver, model, request, columns, queue, listener);
  }

  private void requireRoomForRows(RunSettings settings, int columns) throws LimitExceeded {
    double rows = (settings.tEnd() - settings.tStart()) / settings.tStep() + 2;
    double bytes = rows * columns * Double.BYTES;
    long most = Math.min(limits.resultBytes(), freeDisk());
    if (bytes > most) {
      throw Refusal.limit(
          "resultBytes",
          most,
          (long) bytes,
          "the run would put out "
              + (long) rows
              + " rows of "
              + columns
              + " columns, more than this host keeps; make t-step larger or choose fewer columns");
    }
  }

  private static long freeDisk() {
    try {
      return Files.getFileStore(Path.of(System.getProperty("java.io.tmpdir", ".")))
          .getUsableSpace();
    } catch (IOException e) {
      return Long.MAX_VALUE; // not known: the run itself will find out
    }
  }
}
