package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.MechSimPOATie;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.solver.api.Solver;

/**
 * The sessions of one host. Ends those whose lease is over, tells clients how their runs get on, at
 * most ten times a second each, and runs as many simulations at once as it has capacity.
 */
public final class SessionTable implements AutoCloseable {
  private static final long TICK_MILLIS = 100;
  private static final long CLOSING_MILLIS = 5000;

  private record Entry(Session session, MechSim reference) {}

  private final ServiceOrb orb;
  private final String hostName;
  private final HostLimits limits;
  private final Journal journal;
  private final RunQueue queue;
  private final RunFactory runs;
  private final ModelLibrary library = new ModelLibrary();
  private final ExecutorService callbacks = Executors.newCachedThreadPool(named("callback"));
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(named("clock"));
  private final Map<String, Entry> sessions = new ConcurrentHashMap<>();

  /**
   * Opens an empty table.
   *
   * @param orb serves the sessions
   * @param hostName the host's name at its server
   * @param capacity simulations run at once
   * @param solver runs them
   * @param journal where sessions are written down
   */
  public SessionTable(
      ServiceOrb orb,
      String hostName,
      int capacity,
      HostLimits limits,
      Solver solver,
      Journal journal) {
    this.journal = journal;
    this.orb = orb;
    this.hostName = hostName;
    this.limits = limits;
    queue = new RunQueue(capacity);
    runs = new RunFactory(solver, queue, limits);
    var unused =
        clock.scheduleWithFixedDelay(this::tick, TICK_MILLIS, TICK_MILLIS, TimeUnit.MILLISECONDS);
  }

  private static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, "mechservice-" + name);
      thread.setDaemon(true);
      return thread;
    };
  }

  /**
   * Opens a session.
   *
   * @param owner who asks, for administrators
   * @param client called back; null: nobody
   * @throws LimitExceeded if there are too many
   */
  public MechSim open(String owner, @Nullable IMechClient client) throws LimitExceeded {
    synchronized (sessions) {
      HostLimits.requireBelow(limits.sessions(), sessions.size(), "sessions", "sessions");
      Session session = new Session(owner, client, hostName, limits, orb, callbacks);
      MechSimServant servant =
          new MechSimServant(session, library, runs, () -> end(session, "destroyed"));
      ActiveObject object =
          session.activateSelf(
              new MechSimPOATie(
                  GuardedServant.of(MechSimOperations.class, servant, session::renew)));
      MechSim reference = MechSimHelper.unchecked_narrow(object.reference());
      sessions.put(session.id(), new Entry(session, reference));
      journal.info("session " + session.id() + " of \"" + owner + "\" opened");
      return reference;
    }
  }

  private void end(Session session, String why) {
    if (sessions.remove(session.id()) != null) {
      session.end();
      journal.info("session " + session.id() + " " + why);
    }
  }

  /** Returns a session that is alive. */
  public Optional<MechSim> find(String sessionId) {
    Entry found = sessions.get(sessionId);
    if (found == null) {
      return Optional.empty();
    }
    found.session().renew();
    return Optional.of(found.reference());
  }

  /** Returns how many sessions there are. */
  public int count() {
    return sessions.size();
  }

  /** Returns how many simulations are in one of these states. */
  public int count(SimState... states) {
    List<SimState> wanted = List.of(states);
    return (int) allRuns().stream().filter(run -> wanted.contains(run.state())).count();
  }

  private List<SimulationRun> allRuns() {
    return sessions.values().stream().flatMap(entry -> entry.session().runs().stream()).toList();
  }

  /** Returns all simulations as administrators see them. */
  public List<SimSummary> summaries() {
    List<SimSummary> summaries = new ArrayList<>();
    sessions.values().forEach(entry -> summaries.addAll(entry.session().summaries()));
    return summaries;
  }

  /**
   * Cancels a simulation on behalf of an administrator.
   *
   * @param reason told to the client
   * @return whether there is such a simulation
   */
  public boolean kill(String simId, String reason) {
    for (Entry entry : sessions.values()) {
      for (SimulationRun run : entry.session().runs()) {
        if (run.simId().equals(simId)) {
          entry
              .session()
              .said(
                  run,
                  new Diagnostic[] {
                    Wire.information("S-018", "cancelled by the operator: " + reason)
                  });
          run.cancel();
          journal.info("simulation " + simId + " cancelled by the operator: " + reason);
          return true;
        }
      }
    }
    return false;
  }

  /** Returns what this host allows. */
  public HostLimits limits() {
    return limits;
  }

  private void tick() {
    try {
      for (Entry entry : sessions.values()) {
        Session session = entry.session();
        if (session.leaseLeftMillis() < 0) {
          end(session, "not renewed, ended");
        } else {
          session.runs().forEach(run -> tell(session, run));
        }
      }
    } catch (RuntimeException e) {
      GuardedServant.record("the clock of the sessions", e);
    }
  }

  private static void tell(Session session, SimulationRun run) {
    run.tellHold();
    if (run.hasProgressed()) {
      session.progressed(run);
    }
  }

  /** Ends all sessions and their runs; no thread is left. */
  @Override
  public void close() {
    clock.shutdownNow();
    sessions.values().forEach(entry -> end(entry.session(), "ended with its host"));
    queue.close();
    library.close();
    callbacks.shutdown();
    try {
      queue.awaitEnd(CLOSING_MILLIS);
      callbacks.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
      clock.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
