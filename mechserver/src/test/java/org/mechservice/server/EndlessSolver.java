package org.mechservice.server;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.locks.LockSupport;
import org.mechservice.sim.host.SimHost;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.simulation.Simulation;

/** Puts out one row after the other until it is stopped. */
final class EndlessSolver implements Solver {
  /** A host that runs its models with this solver. */
  static final OwnHost HOST =
      (orb, settings, limits, shutdown) ->
          new SimHost(orb, settings.host(), limits, new EndlessSolver(), shutdown);

  private static final long PAUSE_NANOS = 100_000;

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    List<Variable> columns = Simulation.columns(model, request.columns());
    sink.begin(columns);
    double[] row = new double[columns.size()];
    do {
      sink.row(row);
      row[0]++;
      LockSupport.parkNanos(PAUSE_NANOS);
    } while (control.proceed(row[0], 1, 1, (long) row[0]));
    long rows = (long) row[0];
    return new RunReport(
        new Outcome.Stopped(),
        model.description().name(),
        "",
        request.settings(),
        rows,
        0,
        0,
        rows,
        row[0],
        1,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        "endless");
  }
}
