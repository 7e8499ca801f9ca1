package org.mechservice.sim.service;

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
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.PortableServer.Servant;

/**
 * What one client holds on this host: its simulations, and the lease that any call to any of its
 * objects renews.
 */
final class Session implements SimulationRun.Listener {
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
  private final EventLog events = new EventLog();
  private final ClientNotifier notifier;
  private final Map<SimulationRun, Hosted> simulations = new HashMap<>();
  private final List<ActiveObject> own = new ArrayList<>();
  private final List<EndedRunServant> takenUp = new ArrayList<>();
  private volatile long renewedAt = System.nanoTime();
  private boolean ended;

  /** A simulation with its reference and who hears of it. */
  private record Hosted(
      SimulationServant servant, ActiveObject object, @Nullable IMechClient listener) {}

  /**
   * @param client called back; null: nobody
   */
  Session(String owner, @Nullable IMechClient client, HostServices host) {
    this.owner = owner;
    this.client = client;
    this.host = host;
    notifier = new ClientNotifier(host.callbacks());
  }

  String id() {
    return id;
  }

  String owner() {
    return owner;
  }

  HostServices host() {
    return host;
  }

  HostLimits limits() {
    return host.limits().now();
  }

  EventLog events() {
    return events;
  }

  /** Begins the lease anew. */
  void renew() {
    renewedAt = System.nanoTime();
  }

  /** Returns what is left of the lease, ms; negative if it is over. */
  long leaseLeftMillis() {
    return limits().of(HostLimit.LEASE) * 1000 - (System.nanoTime() - renewedAt) / 1_000_000;
  }

  /** Makes one of the session's objects callable until it or the session ends. */
  synchronized ActiveObject activate(Servant servant) {
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

  synchronized void requirePlaceForSimulation() throws LimitExceeded {
    limits().requireBelow(HostLimit.SIMULATIONS, simulations.size());
  }

  /**
   * Takes a simulation in.
   *
   * @param listener called back about it; null: the session's own client
   */
  synchronized IMechSimRemote add(SimulationRun run, @Nullable IMechClient listener) {
    SimulationServant servant = new SimulationServant(this, run);
    ActiveObject object = activate(guarded(servant));
    simulations.put(run, new Hosted(servant, object, listener == null ? client : listener));
    return IMechSimRemoteHelper.unchecked_narrow(object.reference());
  }

  private IMechSimRemotePOATie guarded(HostedServant servant) {
    return new IMechSimRemotePOATie(
        GuardedServant.of(IMechSimRemoteOperations.class, servant, this::renew));
  }

  /**
   * Takes up a run that has ended.
   *
   * @param destroyed runs when the client gives it up
   */
  IMechSimRemote takeUp(KeptRun run, Runnable destroyed) {
    EndedRunServant servant = new EndedRunServant(this, run, destroyed);
    ActiveObject object = activateSelf(guarded(servant));
    synchronized (this) {
      takenUp.add(servant);
    }
    return IMechSimRemoteHelper.unchecked_narrow(object.reference());
  }

  /** Returns whether it has taken up a run. */
  synchronized boolean hasTakenUp(String simId) {
    return takenUp.stream().anyMatch(servant -> servant.simId().equals(simId));
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

  /** Tells the client and the operator, and writes down, that a simulation changed its state. */
  @Override
  public void stateChanged(SimulationRun run, SimState state, String text) {
    events.status(run.progress(), text);
    host.journal().tell(happening(run, state, text));
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.status(listener, run.simId(), state, text);
    }
  }

  private Happening happening(SimulationRun run, SimState state, String text) {
    boolean failed = state.value() == SimState._SIM_FAILED;
    boolean coded = failed && text.matches("(?s)[MNS]-\\d{3} .*");
    return new Happening(
        KINDS[state.value()],
        failed ? Severity.SEV_WARNING : Severity.SEV_INFO,
        coded ? text.substring(0, 5) : "",
        host.hostName(),
        id,
        run.simId(),
        owner,
        "simulation of " + run.identity().modelName() + ": " + (coded ? text.substring(6) : text));
  }

  /** Tells the client, and writes down, how far a simulation is. */
  void progressed(SimulationRun run) {
    Progress progress = run.progress();
    events.progress(progress);
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.progress(listener, progress);
    }
  }

  /** Tells the client, and writes down, messages about a simulation. */
  void said(SimulationRun run, Diagnostic[] messages) {
    events.messages(run.progress(), messages);
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.messages(listener, run.simId(), messages);
    }
  }

  /**
   * Tells the client, and writes down, that the host is being emptied: it is the client that takes
   * a run elsewhere, because it has the model, the options and the rows so far.
   */
  void hostIsDraining(SimulationRun run) {
    boolean movable = run.checkpoints().isPresent();
    MessageCode code = movable ? MessageCode.HOST_DRAINING : MessageCode.RUN_STAYS_ON_DRAINING_HOST;
    String text =
        "host "
            + host.hostName()
            + " is being emptied; the run "
            + (movable
                ? "goes on on another host if its client takes it there and one has room"
                : "cannot be saved and finishes here");
    tell(run, "drained", Severity.SEV_INFO, code, text);
  }

  /** Tells the client, and writes down, that a cancelled run will not outlive the host. */
  @Override
  public void notOnDisk(SimulationRun run, String why) {
    String text =
        "the results cannot be kept on disk: "
            + why
            + "; they are there as long as host "
            + host.hostName()
            + " runs";
    tell(run, "sim-not-kept", Severity.SEV_WARNING, MessageCode.RESULTS_NOT_KEPT, text);
  }

  private void tell(
      SimulationRun run, String kind, Severity weight, MessageCode code, String text) {
    said(run, new Diagnostic[] {Wire.diagnostic(weight, code, text)});
    host.journal()
        .tell(
            new Happening(
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

  /** Ends the session without its client's wish: what its runs have put out is kept for a while. */
  void expire() {
    end(SimulationRun::leave);
  }

  private void end(Consumer<SimulationRun> each) {
    List<EndedRunServant> others;
    synchronized (this) {
      ended = true;
      own.forEach(ActiveObject::close);
      others = List.copyOf(takenUp);
    }
    others.forEach(HostedServant::closeCursors);
    for (SimulationRun run : runs()) {
      if (close(run)) {
        each.accept(run);
      }
    }
    events.close();
  }
}
