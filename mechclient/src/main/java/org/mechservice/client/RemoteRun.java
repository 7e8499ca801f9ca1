package org.mechservice.client;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.NameValue;
import org.mechservice.solver.api.Failure;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.Variable;

/**
 * A run at the server. Its rows are pulled: in blocks by {@link #toEnd}, or one by one with {@link
 * #start} and {@link #nextRow}. One thread takes the rows; every other method may be called from
 * any thread.
 */
public final class RemoteRun implements PreparedRun {
  /**
   * What the solver refuses in the settings of a run, which is no failure of the simulation; that a
   * limit was reached, or that a worker was lost, is one, and its rows are kept.
   */
  private static final Pattern OF_SETTINGS = Pattern.compile("S-0(08|[67]\\d|81)");

  /** How long one call waits at the server for rows; short enough to notice a lost server soon. */
  private static final Duration BLOCK_WAIT = Duration.ofMillis(500);

  private final RemoteCalls calls;
  private final IMechSimRemote simulation;
  private final LeaseRenewal.Hold simulationHold;
  private final RowCursor rows;
  private final Map<String, Object> facts;
  private boolean started;

  RemoteRun(
      RemoteCalls calls,
      IMechSimRemote simulation,
      LeaseRenewal.Hold simulationHold,
      RowCursor rows,
      Map<String, Object> facts) {
    this.calls = calls;
    this.simulation = simulation;
    this.simulationHold = simulationHold;
    this.rows = rows;
    this.facts = facts;
  }

  /** Returns the simulation's identity at the server. */
  public String id() {
    return calls.get(simulation::simId);
  }

  /** Returns name and unit of every column; the first is time. */
  public List<Variable> columns() {
    return rows.columns();
  }

  @Override
  public List<TunableParameter> parameters() {
    return Stream.of(calls.get(simulation::parameters))
        .map(p -> new TunableParameter(p.name, p.unit, p.value))
        .toList();
  }

  @Override
  public void setParameters(Map<String, String> values) {
    NameValue[] all =
        values.entrySet().stream()
            .map(entry -> new NameValue(entry.getKey(), entry.getValue()))
            .toArray(NameValue[]::new);
    calls.run(() -> simulation.setParameters(all));
  }

  /**
   * Starts the run.
   *
   * @throws InvalidStateException if it was started before
   * @throws LimitExceededException if the host takes no more runs
   */
  public void start() {
    calls.run(simulation::start);
    started = true;
  }

  /**
   * Returns the next row, waiting for it as long as asked.
   *
   * @param wait longest wait
   * @return one number per column; empty if there is no new row yet, or none will come ({@link
   *     #ended})
   */
  public Optional<double[]> nextRow(Duration wait) {
    return rows.next(wait);
  }

  /** Returns whether the last row has been taken. */
  public boolean ended() {
    return rows.ended();
  }

  /** {@inheritDoc} Starts the run if need be and puts out all rows that were not taken yet. */
  @Override
  public RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException {
    sink.begin(columns());
    CheckpointClock clock = new CheckpointClock(store);
    if (!started) {
      prepare(clock, store);
      start();
    }
    try {
      drain(sink, clock);
    } catch (IOException e) {
      cancel();
      throw e;
    }
    return result();
  }

  /** Refuses what cannot be saved before anything is computed. */
  private void prepare(CheckpointClock clock, CheckpointStore store) {
    try {
      if (clock.isWanted()) {
        checkpoint();
      }
      store.saved().ifPresent(saved -> calls.run(() -> simulation.restore(saved)));
    } catch (NotAvailableException e) {
      throw new InvalidOptionException(e.code(), String.valueOf(e.getMessage()), "checkpoint");
    }
  }

  /** Takes the rows; before a checkpoint is kept, those that came before it. */
  private void drain(ResultSink sink, CheckpointClock clock) throws IOException {
    while (!rows.ended()) {
      rows.drainTo(sink, BLOCK_WAIT);
      if (clock.isDue() && !rows.ended()) {
        Optional<byte[]> made = checkpoint();
        long before = progress().rows();
        while (rows.taken() < before && !rows.ended()) {
          rows.drainTo(sink, BLOCK_WAIT);
        }
        clock.keep(made);
      }
    }
    if (clock.isWanted() && progress().state() == RunState.CANCELLED) {
      clock.keep(checkpoint());
    }
  }

  /** Returns a checkpoint of the run as it is now; empty if it takes no step just now. */
  private Optional<byte[]> checkpoint() {
    try {
      return Optional.of(calls.get(simulation::checkpoint));
    } catch (InvalidStateException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns how the run ended.
   *
   * @throws InvalidStateException if it has not ended
   * @throws InvalidOptionException if the solver refused the run's settings
   */
  public RunResult result() {
    RunState state = progress().state();
    Map<String, Object> report = report(state);
    facts.forEach(report::putIfAbsent);
    return new RunResult(outcome(state), report);
  }

  private Map<String, Object> report(RunState state) {
    try {
      return ReportJson.parse(calls.get(simulation::report));
    } catch (InvalidStateException e) {
      if (state != RunState.CANCELLED) {
        throw e;
      }
      // Cancelled in the queue: nothing was computed that could be reported.
      Map<String, Object> report = new LinkedHashMap<>();
      report.put("outcome", "stopped");
      return report;
    }
  }

  private Outcome outcome(RunState state) {
    return switch (state) {
      case FAILED -> new Outcome.Failed(failure(calls.get(simulation::failure)));
      case CANCELLED -> new Outcome.Stopped();
      default -> new Outcome.Completed();
    };
  }

  private static Failure failure(FailureRecord said) {
    if (OF_SETTINGS.matcher(said.code).matches()) {
      throw new InvalidOptionException(said.code, said.text, "");
    }
    return new Failure(
        said.code, said.text, said.simTime, said.stepSize, said.stepOrder, said.part, said.advice);
  }

  /** Holds the run after its current step. */
  public void pause() {
    calls.run(simulation::pause);
  }

  /** Lets a held run go on to its end. */
  public void resume() {
    calls.run(simulation::resume);
  }

  /** Takes one accepted step of the integrator and holds the run again. */
  public void stepOnce() {
    calls.run(simulation::stepOnce);
  }

  /**
   * Lets the run go on until a step reaches a time, then holds it.
   *
   * @param time simulated time, s
   */
  public void runTo(double time) {
    calls.run(() -> simulation.runTo(time));
  }

  @Override
  public void cancel() {
    calls.run(simulation::cancel);
  }

  @Override
  public RunProgress progress() {
    return RunProgress.of(calls.get(simulation::getProgress));
  }

  /** Destroys the run at the server; one that goes on is cancelled by that. */
  @Override
  public void close() {
    rows.close();
    simulationHold.close();
  }
}
