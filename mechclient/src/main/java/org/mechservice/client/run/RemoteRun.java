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
import org.mechservice.client.failure.ServerLostException;
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
 * <p>When an operator drains the host, the thread that takes the rows moves the run: it pauses and
 * saves it, takes its rows up to then, and resumes it from the checkpoint on another host of the
 * server, with the same bits. The run stays on its host if it cannot be saved, if its user has
 * paused it, or if no other host has a free place.
 *
 * <p>When the host is lost, or the process of the run is killed there, {@link #toEnd} computes the
 * run again on a host that takes it and passes on the rows that are still missing.
 */
public final class RemoteRun implements PreparedRun {
  /**
   * Codes of rejected settings, which are not failures of the simulation. A limit that was reached,
   * or a lost worker, is a failure, and the rows are kept.
   */
  private static final Pattern OF_SETTINGS = Pattern.compile("S-0(08|[67]\\d|81)");

  /** Longest wait of one call for rows; short enough to notice a lost server soon. */
  private static final Duration BLOCK_WAIT = Duration.ofMillis(500);

  /** Most hosts a run may lose; a run that ends each of its hosts must not end them all. */
  private static final int MOST_LOSSES = 3;

  /** Pauses before the attempts to find another host, ms; a service manager restarts hosts. */
  private static final long[] SEARCH_PAUSES_MILLIS = {0, 500, 1500, 3000, 5000, 10_000, 10_000};

  private final HostedRun.Opening elsewhere;
  private final Consumer<ModelMessage> listener;
  private final Map<String, String> parameters = new LinkedHashMap<>();
  private final Map<String, Object> facts;
  private final List<String> earlierIds = new ArrayList<>();
  private Optional<String> moved = Optional.empty();

  /** Present host of the run; only the thread that takes the rows changes it. */
  private volatile HostedRun place;

  private volatile boolean cancelled;
  private DrainNotice notice;
  private Optional<RunMigration> move = Optional.empty();
  private Optional<byte[]> resumedFrom = Optional.empty();
  private long takenElsewhere;
  private boolean started;

  /** Whether the run continues by itself; only then it may move. */
  private boolean free;

  /** Simulated time at which the run pauses, s. */
  private double until = Double.POSITIVE_INFINITY;

  /**
   * @param place its first host
   * @param elsewhere opens the run on another host when the host is being drained
   * @param listener receives messages about moves
   */
  public RemoteRun(HostedRun place, HostedRun.Opening elsewhere, Consumer<ModelMessage> listener) {
    this.place = place;
    this.elsewhere = elsewhere;
    this.listener = listener;
    facts = place.facts();
    notice = new DrainNotice(place);
  }

  /**
   * Returns the simulation's id at the server; a run that has moved has a new one, and can also be
   * found by its earlier ones.
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

  /** A call that resumes or pauses the simulation. */
  private interface Steering {
    void on(IMechSimRemoteOperations simulation) throws UserException;
  }

  /** Makes a control call at the run's present host, also while it is about to move. */
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

  /** {@inheritDoc} Starts the run if necessary and passes on all rows not taken yet. */
  @Override
  public RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException {
    RowDeduplication rows = new RowDeduplication(sink, takenElsewhere + place.rows().taken());
    rows.begin(columns());
    CheckpointSchedule clock = new CheckpointSchedule(store);
    if (!started) {
      prepare(clock, store);
      start();
    }
    for (int losses = 1; ; losses++) {
      try {
        drain(rows, clock);
        RunResult result = result();
        if (!wasKilled(result) || !placeAgain(losses)) {
          return result;
        }
        rows.again();
      } catch (ServerLostException lost) {
        placeAgain(lost, "host " + place.hostName() + " was lost", losses);
        rows.again();
      } catch (IOException e) {
        cancel();
        throw e;
      }
    }
  }

  private static boolean wasKilled(RunResult result) {
    return result.outcome() instanceof Outcome.Failed failed
        && failed.failure().code() == MessageCode.WORKER_KILLED;
  }

  /** Starts a run again whose process was killed; returns whether it was started. */
  private boolean placeAgain(int losses) {
    String what = "the process of the run was killed on host " + place.hostName();
    try {
      placeAgain(new ServerLostException(MessageCode.WORKER_KILLED.code(), what, ""), what, losses);
      return true;
    } catch (ServerLostException notPlaced) {
      return false; // the outcome says it
    }
  }

  /**
   * Starts the run again after its host was lost.
   *
   * @param what what has happened
   * @throws ServerLostException the same, if no host takes the run, or the run does not continue by
   *     itself
   */
  private synchronized void placeAgain(ServerLostException lost, String what, int losses) {
    if (!free || cancelled || losses > MOST_LOSSES || Double.isFinite(until)) {
      throw lost;
    }
    HostedRun gone = place;
    HostedRun to = openedAfter(lost);
    try {
      if (!parameters.isEmpty()) {
        to.setParameters(parameters);
      }
      resumedFrom.ifPresent(to::restore);
      to.calls().run(to.simulation()::start);
    } catch (ServiceException e) {
      to.close();
      lost.addSuppressed(e);
      throw lost;
    }
    abandon(gone);
    move.ifPresent(given -> abandon(given.to()));
    move = Optional.empty();
    takenElsewhere = 0;
    place = to;
    notice = new DrainNotice(place);
    if (cancelled) {
      cancel();
    }
    moved = Optional.of("from its start, after " + what);
    tellListener(
        MessageCode.RUN_PLACED_AGAIN,
        what
            + "; the run is computed again on host "
            + place.hostName()
            + " as "
            + id()
            + ", and the rows so far are kept");
  }

  private HostedRun openedAfter(ServerLostException lost) {
    for (long pause : SEARCH_PAUSES_MILLIS) {
      try {
        Thread.sleep(pause);
        return elsewhere.open(earlierIds);
      } catch (ServiceException e) {
        lost.addSuppressed(e);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        break;
      }
      if (cancelled) {
        break;
      }
    }
    throw lost;
  }

  /** Frees what is held of a lost host; calls to it may wait for their timeout. */
  private static void abandon(HostedRun gone) {
    Thread thread = new Thread(gone::close, "mechclient-abandon");
    thread.setDaemon(true);
    thread.start();
  }

  /** Rejects a run that cannot be saved before it starts. */
  private void prepare(CheckpointSchedule clock, CheckpointStore store) {
    try {
      if (clock.isWanted()) {
        place.checkpoint();
      }
      resumedFrom = store.saved();
      resumedFrom.ifPresent(place::restore);
    } catch (NotAvailableException e) {
      throw new InvalidOptionException(e.code(), String.valueOf(e.getMessage()), "checkpoint");
    }
  }

  /** Takes the rows; takes all earlier rows before it stores a checkpoint. */
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
    RunState state = progress().state();
    if (clock.isWanted() && (state == RunState.CANCELLED || state == RunState.FAILED)) {
      clock.keep(place.checkpoint());
    }
  }

  /**
   * Moves the run if its host is being drained: first pauses it, then resumes it on another host.
   */
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

  /** Leaves the host, unless the user has paused the run. */
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
      goesOn = !cancelled && arriving.resumeOnNewHost(until);
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
    tellListener(
        MessageCode.RUN_MOVED,
        "the run goes on on host " + place.hostName() + " as " + id() + " " + how);
  }

  private void stay(String reason) {
    notice.ignore();
    tellListener(
        MessageCode.RUN_STAYS_ON_DRAINING_HOST,
        "the run finishes on host " + place.hostName() + ": " + reason);
  }

  private void tellListener(MessageCode code, String text) {
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

  /** Pauses the run after its current step. */
  public synchronized void pause() {
    steer(IMechSimRemoteOperations::pause, false, until);
  }

  /** Continues a paused run to its end. */
  public synchronized void resume() {
    steer(IMechSimRemoteOperations::resume, true, Double.POSITIVE_INFINITY);
  }

  /** Takes one accepted step of the integrator and pauses the run again. */
  public synchronized void stepOnce() {
    steer(IMechSimRemoteOperations::stepOnce, false, Double.POSITIVE_INFINITY);
  }

  /**
   * Continues the run until a step reaches a time, then pauses it.
   *
   * @param time simulated time, s
   */
  public synchronized void runTo(double time) {
    steer(simulation -> simulation.runTo(time), true, time);
  }

  /** {@inheritDoc} A run that is moving is cancelled on its new host. */
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

  /** Destroys the run at the server; a run in progress is cancelled. */
  @Override
  public synchronized void close() {
    move.ifPresent(given -> given.to().close());
    move = Optional.empty();
    place.close();
  }
}
