package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.IMechSimRemotePOATie;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.PortableServer.Servant;

/**
 * What one client holds on this host: its simulations, and the lease that any call to any of its
 * objects renews.
 */
final class Session {
  private final String id = UUID.randomUUID().toString();
  private final String owner;
  private final @Nullable IMechClient client;
  private final String hostName;
  private final HostLimits limits;
  private final ServiceOrb orb;
  private final EventLog events = new EventLog();
  private final ClientNotifier notifier;
  private final Map<SimulationRun, Hosted> simulations = new HashMap<>();
  private final List<ActiveObject> own = new ArrayList<>();
  private volatile long renewedAt = System.nanoTime();
  private boolean ended;

  /** A simulation with its reference and who hears of it. */
  private record Hosted(
      SimulationServant servant,
      ActiveObject object,
      @Nullable IMechClient listener,
      long createdAt) {}

  /**
   * @param client called back; null: nobody
   * @param callbacks threads that call the client back
   */
  Session(
      String owner,
      @Nullable IMechClient client,
      String hostName,
      HostLimits limits,
      ServiceOrb orb,
      Executor callbacks) {
    this.owner = owner;
    this.client = client;
    this.hostName = hostName;
    this.limits = limits;
    this.orb = orb;
    notifier = new ClientNotifier(callbacks);
  }

  String id() {
    return id;
  }

  String hostName() {
    return hostName;
  }

  HostLimits limits() {
    return limits;
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
    return limits.lease().toMillis() - (System.nanoTime() - renewedAt) / 1_000_000;
  }

  /** Makes one of the session's objects callable until it or the session ends. */
  synchronized ActiveObject activate(Servant servant) {
    requireAlive();
    return orb.activate(servant);
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
    HostLimits.requireBelow(
        limits.simulations(), simulations.size(), "simulations", "simulations of one session");
  }

  /**
   * Takes a simulation in.
   *
   * @param listener called back about it; null: the session's own client
   */
  synchronized IMechSimRemote add(
      SimulationRun run, SimulationServant servant, @Nullable IMechClient listener) {
    ActiveObject object =
        activate(
            new IMechSimRemotePOATie(
                GuardedServant.of(IMechSimRemoteOperations.class, servant, this::renew)));
    simulations.put(
        run,
        new Hosted(
            servant, object, listener == null ? client : listener, System.currentTimeMillis()));
    return IMechSimRemoteHelper.unchecked_narrow(object.reference());
  }

  /** Tells the client, and writes down, that a simulation changed its state. */
  void stateChanged(SimulationRun run, SimState state, String text) {
    events.status(run.progress(), text);
    IMechClient listener = listenerOf(run);
    if (listener != null) {
      notifier.status(listener, run.simId(), state, text);
    }
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
    Map<SimulationRun, Hosted> present;
    synchronized (this) {
      present = Map.copyOf(simulations);
    }
    List<SimSummary> summaries = new ArrayList<>();
    present.forEach((run, hosted) -> summaries.add(summary(run, hosted)));
    return summaries;
  }

  private SimSummary summary(SimulationRun run, Hosted hosted) {
    return new SimSummary(
        run.simId(),
        id,
        hostName,
        run.modelName(),
        owner,
        run.progress(),
        hosted.createdAt(),
        System.currentTimeMillis() + leaseLeftMillis());
  }

  /** Ends a simulation, its cursors and its rows. */
  void destroy(SimulationRun run) {
    Hosted hosted;
    synchronized (this) {
      hosted = simulations.remove(run);
    }
    if (hosted != null) {
      hosted.object().close();
      hosted.servant().closeCursors();
      run.destroy();
    }
  }

  /** Ends the session with all it owns. Idempotent. */
  void end() {
    synchronized (this) {
      ended = true;
      own.forEach(ActiveObject::close);
    }
    runs().forEach(this::destroy);
    events.close();
  }
}
