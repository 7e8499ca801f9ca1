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
 * A run at the server that another client has started, or this client before a restart. The run is
 * kept alive as long as this object is open. Afterwards a run in progress lives as long as its own
 * session, and a run that has ended for the server's retention time.
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

  /**
   * Returns the run's id at the server, which differs from the one it was found by if it has moved.
   */
  public String id() {
    return id;
  }

  /** Returns name and unit of every column; the first is time. */
  public List<Variable> columns() {
    return rows.columns();
  }

  /**
   * Returns the progress of the run.
   *
   * @throws ServiceException if the server is lost
   */
  public RunProgress progress() {
    return RunProgress.of(calls.read(simulation::getProgress));
  }

  /**
   * Passes on all rows from the first one, and waits for further rows.
   *
   * @return outcome of the run; a run that was cut off has failed
   * @throws IOException if the sink cannot store a row
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

  /** Detaches from the run, which stays at the server. */
  @Override
  public void close() {
    rows.close();
    hold.release();
  }
}
