package org.mechservice.client.run;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;

/**
 * A run at the server that somebody else has started, or this client before it was lost. It is kept
 * alive as long as this is open, and stays at the server afterwards: for as long as what started it
 * lives while it goes on, for the server's retention time once it has ended.
 */
public final class ReattachedRun implements AutoCloseable {
  private static final Duration BLOCK_WAIT = Duration.ofMillis(500);

  private final String id;
  private final RemoteCalls calls;
  private final IMechSimRemote simulation;
  private final LeaseRenewal.Hold hold;
  private final RowCursor rows;

  public ReattachedRun(RemoteCalls calls, LeaseRenewal leases, IMechSimRemote simulation) {
    this.calls = calls;
    id = calls.read(simulation::simId);
    this.simulation = simulation;
    rows = RowCursor.open(calls, leases, simulation);
    hold = leases.hold(simulation);
  }

  /** Returns the run's identity at the server, another than it was found by if it has moved. */
  public String id() {
    return id;
  }

  /** Returns name and unit of every column; the first is time. */
  public List<Variable> columns() {
    return rows.columns();
  }

  /**
   * Returns how far the run is.
   *
   * @throws ServiceException if the server is lost
   */
  public RunProgress progress() {
    return RunProgress.of(calls.read(simulation::getProgress));
  }

  /**
   * Puts out all rows from the first on, waiting for those to come.
   *
   * @return how the run ended; a run that was cut off has failed
   * @throws IOException if the sink cannot keep a row
   * @throws ServiceException if the server is lost; the sink has the rows up to then
   */
  public RunResult toEnd(ResultSink sink) throws IOException {
    sink.begin(columns());
    while (!rows.ended()) {
      rows.drainTo(sink, BLOCK_WAIT);
    }
    RunState state = progress().state();
    Map<String, Object> report = report(state);
    return new RunResult(outcome(state, report), report);
  }

  private Outcome outcome(RunState state, Map<String, Object> report) {
    return switch (state) {
      case FAILED -> new Outcome.Failed(FailureReader.of(calls.read(simulation::failure), report));
      case CANCELLED -> new Outcome.Stopped();
      default -> new Outcome.Completed();
    };
  }

  /** A run that was cut off, or cancelled before it began, has no report. */
  private Map<String, Object> report(RunState state) {
    try {
      return ReportJson.parse(calls.read(simulation::report));
    } catch (InvalidStateException e) {
      Map<String, Object> report = new LinkedHashMap<>();
      report.put("outcome", state == RunState.FAILED ? "failed" : "stopped");
      return report;
    }
  }

  /** Lets the run go; it stays at the server. */
  @Override
  public void close() {
    rows.close();
    hold.release();
  }
}
