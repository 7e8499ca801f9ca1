package org.mechservice.sim.service.testing;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.locks.LockSupport;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.simulation.Simulation;

/**
 * Puts out row after row as slowly as it is told, one per step of 1 s: row i begins with time i,
 * the rest is i * 1000 + column.
 */
public final class PacedSolver implements Solver {
  private final long rows;
  private final long pauseNanos;

  /**
   * @param rows rows to put out
   * @param pauseNanos pause after each, ns
   */
  public PacedSolver(long rows, long pauseNanos) {
    this.rows = rows;
    this.pauseNanos = pauseNanos;
  }

  /** A solver that never ends by itself, with a pause after each row. */
  public static PacedSolver endless() {
    return new PacedSolver(Long.MAX_VALUE, 100_000);
  }

  /** A solver that never ends by itself, puts out one row and keeps its processor busy. */
  public static Solver busy() {
    return (model, request, sink, control) -> {
      List<Variable> columns = Simulation.columns(model, request.columns());
      sink.begin(columns);
      sink.row(new double[columns.size()]);
      long steps = 0;
      while (control.proceed((double) steps, 1, 1, steps)) {
        steps++;
      }
      return report(model, request, new Outcome.Stopped(), steps);
    };
  }

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    List<Variable> columns = Simulation.columns(model, request.columns());
    sink.begin(columns);
    double[] row = new double[columns.size()];
    for (long i = 0; i < rows; i++) {
      row[0] = i;
      for (int column = 1; column < row.length; column++) {
        row[column] = i * 1000.0 + column;
      }
      sink.row(row);
      if (!control.proceed(row[0], 1, 1, i)) {
        return report(model, request, new Outcome.Stopped(), i);
      }
      LockSupport.parkNanos(pauseNanos);
    }
    return report(model, request, new Outcome.Completed(), rows);
  }

  private static RunReport report(Model model, RunRequest request, Outcome outcome, long rows) {
    return new RunReport(
        outcome,
        model.description().name(),
        model.description().formulation(),
        request.settings(),
        rows,
        0,
        0,
        rows,
        rows,
        1,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        "paced");
  }
}
