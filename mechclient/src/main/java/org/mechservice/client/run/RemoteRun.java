package org.mechservice.client.run;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.NotAvailableException;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.UserException;

/**
 * A run at the server. Its rows are pulled: in blocks by {@link #toEnd}, or one by one with {@link
 * #start} and {@link #nextRow}. One thread takes the rows; every other method may be called from
 * any thread.
 *
 * <p>When an operator empties the host, the thread that takes the rows moves the run: it holds and
 * saves it, takes its rows up to then, and lets it go on from the checkpoint on another host of the
 * server, to the same bits. A run that cannot be saved, that its user holds, or that no other host
 * has room for stays where it is.
 */
public final class RemoteRun implements PreparedRun {
  /**
   * What the solver refuses in the settings of a run, which is no failure of the simulation; that a
   * limit was reached, or that a worker was lost, is one, and its rows are kept.
   */
  private static final Pattern OF_SETTINGS = Pattern.compile("S-0(08|[67]\\d|81)");

  /** How long one call waits at the server for rows; short enough to notice a lost server soon. */
  private static final Duration BLOCK_WAIT = Duration.ofMillis(500);

  private final HostedRun.Opening elsewhere;
  private final Consumer<ModelMessage> listener;
  private final Map<String, String> parameters = new LinkedHashMap<>();
  private final Map<String, Object> facts;
  private final List<String> earlierIds = new ArrayList<>();
  private Optional<String> moved = Optional.empty();

  /** Where the run is; only the thread that takes the rows changes it. */
  private volatile HostedRun place;

  private volatile boolean cancelled;
  private DrainNotice notice;
  private Optional<RunMigration> move = Optional.empty();
  private long takenElsewhere;
  private boolean started;

  /** Whether the run may go on by itself; then it may also go on elsewhere. */
  private boolean free;

  /** Where the run shall be held, s. */
  private double until = Double.POSITIVE_INFINITY;

  /**
   * @param place where it begins
   * @param elsewhere opens another place when the host is being emptied
   * @param listener hears what becomes of it then
   */
  public RemoteRun(HostedRun place, HostedRun.Opening elsewhere, Consumer<ModelMessage> listener) {
    this.place = place;
    this.elsewhere = elsewhere;
    this.listener = listener;
    facts = place.facts();
    notice = new DrainNotice(place);
  }

  /**
   * Returns the simulation's identity at the server; a run that has moved has a new one, and is
   * found under those it had, too.
   */
  public String id() {
    return place.id();
  }

  /** Returns name and unit of every column; the first is time. */
  public List<Variable> columns() {
    return place.rows().columns();
  }

  @Override
  public List<TunableParameter> parameters() {
    HostedRun here = place;
    return Stream.of(here.calls().read(here.simulation()::parameters))
        .map(p -> new TunableParameter(p.name, p.unit, p.value))
        .toList();
  }

  @Override
  public synchronized void setParameters(Map<String, String> values) {
    place.setParameters(values);
    parameters.putAll(values);
  }

  /**
   * Starts the run.
   *
   * @throws InvalidStateException if it was started before
   * @throws LimitExceededException if the host takes no more runs
   */
  public synchronized void start() {
    steer(IMechSimRemoteOperations::start, true, until);
  }

  /** A call on the simulation that lets it go on, or holds it. */
  private interface Steering {
    void on(IMechSimRemoteOperations simulation) throws UserException;
  }

  /** Who steers a run that is about to move steers it where it is. */
  private void steer(Steering call, boolean goesOnFreely, double heldAt) {
    move.ifPresent(given -> given.to().close());
    move = Optional.empty();
    HostedRun here = place;
    here.calls().run(() -> call.on(here.simulation()));
    started = true;
    free = goesOnFreely;
    until = heldAt;
  }

  /**
   * Returns the next row, waiting for it as long as asked.
   *
   * @param wait longest wait
   * @return one number per column; empty if there is no new row yet, or none will come ({@link
   *     #ended})
   */
  public Optional<double[]> nextRow(Duration wait) {
    follow();
    return place.rows().next(wait);
  }

  /** Returns whether the last row has been taken. */
  public boolean ended() {
    return place.rows().ended();
  }

  /** {@inheritDoc} Starts the run if need be and puts out all rows that were not taken yet. */
  @Override
  public RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException {
    sink.begin(columns());
    CheckpointSchedule clock = new CheckpointSchedule(store);
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
  private void prepare(CheckpointSchedule clock, CheckpointStore store) {
    try {
      if (clock.isWanted()) {
        place.checkpoint();
      }
      store.saved().ifPresent(place::restore);
    } catch (NotAvailableException e) {
      throw new InvalidOptionException(e.code(), String.valueOf(e.getMessage()), "checkpoint");
    }
  }

  /** Takes the rows; before a checkpoint is kept, those that came before it. */
  private void drain(ResultSink sink, CheckpointSchedule clock) throws IOException {
    while (!ended()) {
      follow();
      place.rows().drainTo(sink, BLOCK_WAIT);
      if (clock.isDue() && !ended()) {
        Optional<byte[]> made = place.checkpoint();
        long before = place.progress().rows();
        while (place.rows().taken() < before && !ended()) {
          place.rows().drainTo(sink, BLOCK_WAIT);
        }
        clock.keep(made);
      }
    }
    if (clock.isWanted() && progress().state() == RunState.CANCELLED) {
      clock.keep(place.checkpoint());
    }
  }

  /** Goes on on another host if this one is being emptied: first holds, then moves. */
  private void follow() {
    if (ended()) {
      return;
    }
    synchronized (this) {
      if (started && move.isEmpty() && notice.isTimeToLeave()) {
        leave();
      }
      if (move.isPresent() && place.rows().taken() >= move.get().rows()) {
        arrive(move.get());
      }
    }
  }

  /** What its user holds stays where it is, until it is let go. */
  private void leave() {
    RunState state = place.progress().state();
    if (!free || cancelled || (state != RunState.RUNNING && state != RunState.QUEUED)) {
      return;
    }
    try {
      List<String> ids = new ArrayList<>(earlierIds);
      ids.add(id());
      HostedRun to = elsewhere.open(ids);
      try {
        move = RunMigration.begin(place, to, parameters, until);
      } finally {
        if (move.isEmpty()) {
          to.close();
        }
      }
    } catch (ServiceException e) {
      stay(String.valueOf(e.getMessage()));
    }
  }

  private void arrive(RunMigration arriving) {
    move = Optional.empty();
    HostedRun from = place;
    String reason = "host " + arriving.to().hostName() + " has no room for it now";
    boolean goesOn = false;
    try {
      goesOn = !cancelled && arriving.goesOn(until);
    } catch (ServiceException e) {
      reason = String.valueOf(e.getMessage());
    }
    if (!goesOn) {
      arriving.giveUp(until);
      stay(reason);
      return;
    }
    takenElsewhere += from.rows().taken();
    earlierIds.add(from.id());
    place = arriving.to();
    notice = new DrainNotice(place);
    from.close();
    if (cancelled) {
      cancel();
    }
    String how = "from t=" + arriving.time() + " s on, before on host " + from.hostName();
    moved = Optional.of(how);
    say(
        MessageCode.RUN_MOVED,
        "the run goes on on host " + place.hostName() + " as " + id() + " " + how);
  }

  private void stay(String reason) {
    notice.ignore();
    say(
        MessageCode.RUN_STAYS_ON_DRAINING_HOST,
        "the run finishes on host " + place.hostName() + ": " + reason);
  }

  private void say(MessageCode code, String text) {
    listener.accept(new ModelMessage(ModelMessage.Severity.INFO, code.code(), text, "", 0, 0, ""));
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
    moved.ifPresent(how -> report.put("where", "remote, host " + place.hostName() + " " + how));
    return new RunResult(outcome(state, report), report);
  }

  private Map<String, Object> report(RunState state) {
    try {
      return ReportJson.parse(place.calls().read(place.simulation()::report));
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

  private Outcome outcome(RunState state, Map<String, Object> report) {
    return switch (state) {
      case FAILED ->
          new Outcome.Failed(failure(place.calls().read(place.simulation()::failure), report));
      case CANCELLED -> new Outcome.Stopped();
      default -> new Outcome.Completed();
    };
  }

  private static Failure failure(FailureRecord said, Map<String, Object> report) {
    if (OF_SETTINGS.matcher(said.code).matches()) {
      throw new InvalidOptionException(said.code, said.text, "");
    }
    return FailureReader.of(said, report);
  }

  /** Holds the run after its current step. */
  public synchronized void pause() {
    steer(IMechSimRemoteOperations::pause, false, until);
  }

  /** Lets a held run go on to its end. */
  public synchronized void resume() {
    steer(IMechSimRemoteOperations::resume, true, Double.POSITIVE_INFINITY);
  }

  /** Takes one accepted step of the integrator and holds the run again. */
  public synchronized void stepOnce() {
    steer(IMechSimRemoteOperations::stepOnce, false, Double.POSITIVE_INFINITY);
  }

  /**
   * Lets the run go on until a step reaches a time, then holds it.
   *
   * @param time simulated time, s
   */
  public synchronized void runTo(double time) {
    steer(simulation -> simulation.runTo(time), true, time);
  }

  /** {@inheritDoc} Also while the run moves: it is cancelled wherever it is then. */
  @Override
  public void cancel() {
    cancelled = true;
    HostedRun here = place;
    here.calls().run(here.simulation()::cancel);
  }

  @Override
  public synchronized RunProgress progress() {
    return place.progress().after(takenElsewhere);
  }

  /** Destroys the run at the server; one that goes on is cancelled by that. */
  @Override
  public synchronized void close() {
    move.ifPresent(given -> given.to().close());
    move = Optional.empty();
    place.close();
  }
}
