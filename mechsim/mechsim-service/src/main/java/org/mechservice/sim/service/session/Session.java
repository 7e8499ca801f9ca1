package org.mechservice.sim.service.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.IMechSimRemotePOATie;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.connection.ReplyMemory;
import org.mechservice.sim.service.contract.ClientNotifier;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.sim.service.contract.OwnerGate;
import org.mechservice.sim.service.contract.SessionEvents;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.results.ResultCursors;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.sim.service.run.SimulationRun;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.PortableServer.Servant;

/**
 * One client's session on this host: owns its simulations and their cursors. Every call to one of
 * its objects renews its lease. Thread-safe.
 */
final class Session implements SimulationRun.Listener, ResultCursors.Owner {
  /** Kinds of events, by state. */
  private static final String[] KINDS = {
    "sim-created",
    "sim-queued",
    "sim-running",
    "sim-paused",
    "sim-done",
    "sim-failed",
    "sim-cancelled"
  };

  private final String id = UUID.randomUUID().toString();
  private final String owner;
  private final @Nullable IMechClient client;
  private final HostServices host;
  private final SessionEvents events = new SessionEvents();
  private final ClientNotifier notifier;
  private final Map<SimulationRun, Hosted> simulations = new HashMap<>();
  private final List<ActiveObject> own = new ArrayList<>();
  private final List<EndedRunServant> reopened = new ArrayList<>();
  private final OwnerGate gate;
  private final long openedAt = System.currentTimeMillis();
  private volatile long renewedAt = System.nanoTime();
  private volatile long modelBytes;
  private Runnable stopCalls = () -> {};
  private boolean ended;

  /** A simulation with its servant, its reference and the client that is called back about it. */
  private record Hosted(
      SimulationServant servant, ActiveObject object, @Nullable IMechClient listener) {}

  /**
   * @param client called back; null: none
   */
  Session(String owner, @Nullable IMechClient client, HostServices host) {
    this.owner = owner;
    this.client = client;
    this.host = host;
    notifier = new ClientNotifier(host.callbacks());
    gate = new OwnerGate(owner, this::renew, host.denials());
  }

  String id() {
    return id;
  }

  String owner() {
    return owner;
  }

  /** Returns when it was opened; UTC, ms since 1970-01-01. */
  long openedAt() {
    return openedAt;
  }

  /** Returns the size of its model with its files, B. */
  long modelBytes() {
    return modelBytes;
  }

  /** Returns the size of its model, and of the models and columns of its simulations, B. */
  long heldBytes() {
    long ofRuns =
        runs().stream()
            .mapToLong(run -> run.identity().modelText().length() + run.columns().characters())
            .sum();
    return modelBytes + ofRuns;
  }

  void holdsModel(long bytes) {
    modelBytes = bytes;
  }

  HostServices host() {
    return host;
  }

  @Override
  public HostLimits limits() {
    return host.limits().now();
  }

  SessionEvents events() {
    return events;
  }

  @Override
  public OwnerGate gate() {
    return gate;
  }

  void renew() {
    renewedAt = System.nanoTime();
  }

  /** Returns the time left of the lease, ms; negative if it is over. */
  long leaseLeftMillis() {
    return limits().leaseSeconds() * 1000L - (System.nanoTime() - renewedAt) / 1_000_000;
  }

  @Override
  public ReplyMemory replyRoom() {
    return host.orb().replyRoom();
  }

  @Override
  public synchronized ActiveObject activate(Servant servant) {
    requireAlive();
    return host.orb().activate(servant);
  }

  /** Makes the session itself callable. */
  synchronized ActiveObject activateSelf(Servant servant) {
    ActiveObject object = activate(servant);
    own.add(object);
    return object;
  }

  private void requireAlive() {
    if (ended) {
      throw new OBJECT_NOT_EXIST("the session has ended");
    }
  }

  /** Returns whether one of its simulations has not ended. */
  boolean hasActiveRun() {
    return runs().stream().anyMatch(run -> !run.ended());
  }

  /** Returns the number of simulations. */
  synchronized int simulationCount() {
    return simulations.size();
  }

  /**
   * Adds a simulation and makes it callable.
   *
   * @param listener called back about it; null: the client of the session
   */
  synchronized IMechSimRemote add(SimulationRun run, @Nullable IMechClient listener) {
    SimulationServant servant = new SimulationServant(this, run);
    ActiveObject object = activate(guarded(servant));
    simulations.put(run, new Hosted(servant, object, listener == null ? client : listener));
    return IMechSimRemoteHelper.unchecked_narrow(object.reference());
  }

  private IMechSimRemotePOATie guarded(IMechSimRemoteOperations servant) {
    return new IMechSimRemotePOATie(
        GuardedServant.of(IMechSimRemoteOperations.class, servant, gate));
  }

  /**
   * Reopens a run that has ended.
   *
   * @param rows of it
   * @param destroyed called when the client destroys its reference
   */
  IMechSimRemote reopen(RunRecord run, ResultSpool rows, Runnable destroyed) {
    EndedRunServant servant = new EndedRunServant(this, run, rows, destroyed);
    ActiveObject object = activateSelf(guarded(servant));
    synchronized (this) {
      reopened.add(servant);
    }
    return IMechSimRemoteHelper.unchecked_narrow(object.reference());
  }

  /** Sets the action that stops the pending calls when the session ends. */
  synchronized void endsWith(Runnable stop) {
    stopCalls = stop;
  }

  /** Returns whether the session has reopened an ended run. */
  synchronized boolean hasReopened(String simId) {
    return reopened.stream().anyMatch(servant -> servant.simId().equals(simId));
  }

  /**
   * Opens a cursor over all columns of a simulation of this session.
   *
   * @throws LimitExceeded if it has too many
   */
  ResultCursor openRows(SimulationRun run) throws LimitExceeded {
    Hosted hosted;
    synchronized (this) {
      hosted = simulations.get(run);
    }
    if (hosted == null) {
      throw new OBJECT_NOT_EXIST("the simulation was destroyed");
    }
    return hosted.servant().openAllResults();
  }

  /** Returns the reference of a simulation of this session, by its id or an earlier one. */
  synchronized Optional<IMechSimRemote> find(String simId) {
    return simulations.entrySet().stream()
        .filter(entry -> entry.getKey().identity().answersTo(simId))
        .map(entry -> IMechSimRemoteHelper.unchecked_narrow(entry.getValue().object().reference()))
        .findFirst();
  }

  /** Records a change of state as an event and in the journal, and calls the client back. */
  @Override
  public void stateChanged(SimulationRun run, SimState state, String text) {
    events.status(run.progress(), text);
    host.journal().add(entry(run, state, text));
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.status(listener, run.simId(), state, text);
    }
  }

  private JournalEntry entry(SimulationRun run, SimState state, String text) {
    boolean failed = state.value() == SimState._SIM_FAILED;
    boolean coded = failed && text.matches("(?s)[MNS]-\\d{3} .*");
    return new JournalEntry(
        KINDS[state.value()],
        failed ? Severity.SEV_WARNING : Severity.SEV_INFO,
        coded ? text.substring(0, 5) : "",
        host.hostName(),
        id,
        run.simId(),
        owner,
        "simulation of " + run.identity().modelName() + ": " + (coded ? text.substring(6) : text));
  }

  /** Records the progress of a simulation as an event, and calls the client back. */
  void progressed(SimulationRun run) {
    Progress progress = run.progress();
    events.progress(progress);
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.progress(listener, progress);
    }
  }

  /** Records messages about a simulation as an event, and calls the client back. */
  void recordMessages(SimulationRun run, Diagnostic[] messages) {
    events.messages(run.progress(), messages);
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.messages(listener, run.simId(), messages);
    }
  }

  /**
   * Reports that the host is being emptied. The client moves the run to another host, because it
   * has the model, the options and the rows so far.
   */
  void hostIsDraining(SimulationRun run) {
    boolean movable = run.canBeSaved();
    MessageCode code = movable ? MessageCode.HOST_DRAINING : MessageCode.RUN_STAYS_ON_DRAINING_HOST;
    String text =
        "host "
            + host.hostName()
            + " is being emptied; the run "
            + (movable
                ? "goes on on another host if its client takes it there and one has room"
                : "cannot be saved and finishes here");
    report(run, "drained", Severity.SEV_INFO, code, text);
  }

  /** Reports that a cancelled run will not outlive the host. */
  @Override
  public void notOnDisk(SimulationRun run, String why) {
    String text =
        "the results cannot be kept on disk: "
            + why
            + "; they are there as long as host "
            + host.hostName()
            + " runs";
    report(run, "sim-not-kept", Severity.SEV_WARNING, MessageCode.RESULTS_NOT_KEPT, text);
  }

  private void report(
      SimulationRun run, String kind, Severity weight, MessageCode code, String text) {
    recordMessages(run, new Diagnostic[] {ContractTypes.diagnostic(weight, code, text)});
    host.journal()
        .add(
            new JournalEntry(
                kind,
                weight,
                code.code(),
                host.hostName(),
                id,
                run.simId(),
                owner,
                "simulation of " + run.identity().modelName() + ": " + text));
  }

  private synchronized @Nullable IMechClient listenerOf(SimulationRun run) {
    Hosted hosted = simulations.get(run);
    return hosted == null ? null : hosted.listener();
  }

  /** Returns the simulations. */
  synchronized List<SimulationRun> runs() {
    return List.copyOf(simulations.keySet());
  }

  /** Returns the simulations as administrators see them. */
  List<SimSummary> summaries() {
    long leaseEnd = System.currentTimeMillis() + leaseLeftMillis();
    return runs().stream().map(run -> run.summary(leaseEnd)).toList();
  }

  /** Ends a simulation, its cursors and its rows. */
  void destroy(SimulationRun run) {
    if (close(run)) {
      run.destroy();
    }
  }

  private boolean close(SimulationRun run) {
    Hosted hosted;
    synchronized (this) {
      hosted = simulations.remove(run);
    }
    if (hosted != null) {
      hosted.object().close();
      hosted.servant().closeCursors();
    }
    return hosted != null;
  }

  /** Ends the session with all it owns. Idempotent. */
  void end() {
    end(SimulationRun::destroy);
  }

  /** Ends a session whose lease is over; the rows of its runs are kept for the retention time. */
  void expire() {
    end(SimulationRun::leave);
  }

  private void end(Consumer<SimulationRun> each) {
    List<EndedRunServant> others;
    synchronized (this) {
      ended = true;
      stopCalls.run();
      own.forEach(ActiveObject::close);
      others = List.copyOf(reopened);
    }
    others.forEach(EndedRunServant::closeCursors);
    for (SimulationRun run : runs()) {
      if (close(run)) {
        each.accept(run);
      }
    }
    events.close();
  }
}
