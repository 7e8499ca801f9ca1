package org.mechservice.sim.service.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.MechSimPOATie;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.tls.Caller;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.AdmissionControl;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.limits.SetUpPlaces;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.service.run.RunQueue;
import org.mechservice.sim.service.run.SimulationRun;
import org.mechservice.sim.service.setup.SetUpWorkers;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;

/**
 * The sessions of one host. Its clock ends sessions whose lease is over and runs that have reached
 * a limit, and reports the progress of runs to their clients, at most ten times a second each. As
 * many simulations run at once as the host has capacity.
 */
public final class SessionTable implements AutoCloseable {
  private static final long TICK_MILLIS = 100;
  private static final long EXPIRY_SECONDS = 10;

  /**
   * Interval of writing rows to disk, s: at most so much of a run is lost if its host is killed.
   */
  private static final long HAND_OVER_SECONDS = 1;

  private static final long CLOSING_MILLIS = 5000;

  /** A session with its reference; one that only holds a reopened run has none. */
  private record Entry(Session session, Optional<MechSim> reference) {}

  private final HostServices host;
  private final RunQueue queue;
  private final RunFactory runs;
  private final ClassLibrary classes = new ClassLibrary();
  private final SetUpWorkers setUps;
  private final CheckReports reports;
  private final ExecutorService callbacks;
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(named("clock"));
  private final Map<String, Entry> sessions = new ConcurrentHashMap<>();
  private final AdmissionControl admission;
  private final SetUpPlaces places;
  private final AtomicLong opened = new AtomicLong();
  private volatile Future<?> handedOver = CompletableFuture.completedFuture(null);

  /**
   * Opens a table, with the runs an earlier process has left in the folder.
   *
   * @param orb serves the sessions
   * @param hostName the host's name at its server
   * @param capacity simulations run at once
   * @param limits what the host allows
   * @param spool folder in which ended runs outlive the process; empty: they do not
   * @param solver runs them
   * @param journal logs the sessions
   * @param denials logs refused calls
   * @param userCode where classes of users run
   * @throws IllegalArgumentException with code S-114 if the folder cannot be used
   */
  public SessionTable(
      ServiceOrb orb,
      String hostName,
      int capacity,
      CurrentLimits limits,
      Optional<Path> spool,
      Solver solver,
      Journal journal,
      DenialLog denials,
      UserCodePolicy userCode) {
    RunStore store = new RunStore(spool, limits);
    callbacks = Executors.newCachedThreadPool(named("callback"));
    host = new HostServices(orb, hostName, limits, journal, denials, store, callbacks, userCode);
    queue = new RunQueue(capacity, limits);
    runs = new RunFactory(solver, queue, store);
    admission = new AdmissionControl(limits, this::runsOf);
    places = new SetUpPlaces(limits);
    setUps = new SetUpWorkers(limits, classes);
    reports = new CheckReports(setUps.setUps(), callbacks);
    var unused =
        clock.scheduleWithFixedDelay(this::tick, TICK_MILLIS, TICK_MILLIS, TimeUnit.MILLISECONDS);
    if (store.lasts()) {
      unused =
          clock.scheduleWithFixedDelay(
              this::handOverRows, HAND_OVER_SECONDS, HAND_OVER_SECONDS, TimeUnit.SECONDS);
    }
    unused =
        clock.scheduleWithFixedDelay(
            () -> store.expire(this::isReopened), 0, EXPIRY_SECONDS, TimeUnit.SECONDS);
  }

  /** Returns what reads and builds the models of the sessions. */
  public SetUpWorkers setUps() {
    return setUps;
  }

  /** Writes rows in the disk thread, unless the previous write has not ended. */
  private void handOverRows() {
    if (handedOver.isDone()) {
      handedOver = host.store().soon("", () -> allRuns().forEach(SimulationRun::handOverRows));
    }
  }

  private boolean isReopened(String simId) {
    return allSessions().stream().anyMatch(session -> session.hasReopened(simId));
  }

  private static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, "mechservice-" + name);
      thread.setDaemon(true);
      return thread;
    };
  }

  private long runsOf(String client) {
    return allSessions().stream()
        .filter(session -> session.owner().equals(client))
        .flatMap(session -> session.runs().stream())
        .filter(run -> !run.ended())
        .count();
  }

  private long modelBytesOf(String client) {
    return sessionsOf(client).stream().mapToLong(Session::heldBytes).sum();
  }

  private List<Session> sessionsOf(String client) {
    return allSessions().stream().filter(session -> session.owner().equals(client)).toList();
  }

  private Collection<Session> allSessions() {
    return sessions.values().stream().map(Entry::session).toList();
  }

  /**
   * Opens a session.
   *
   * @param owner name of the client, for administrators
   * @param client called back; null: none
   * @throws LimitExceeded if there are too many
   */
  public MechSim open(String owner, @Nullable IMechClient client) throws LimitExceeded {
    synchronized (sessions) {
      Session session = admitted(owner, client);
      MechSimServant servant =
          new MechSimServant(
              session,
              setUps.setUps(),
              classes,
              runs,
              admission,
              () -> modelBytesOf(session.owner()),
              () -> end(session, "was ended by its client"));
      SessionCalls calls = new SessionCalls(servant, owner, places);
      ActiveObject object =
          session.activateSelf(
              new MechSimPOATie(
                  GuardedServant.of(MechSimOperations.class, calls.watched(), session.gate())));
      session.endsWith(calls::end);
      MechSim reference = MechSimHelper.unchecked_narrow(object.reference());
      sessions.put(session.id(), new Entry(session, Optional.of(reference)));
      opened.incrementAndGet();
      log(session, "session-opened", "was opened");
      return reference;
    }
  }

  private Session admitted(String owner, @Nullable IMechClient client) throws LimitExceeded {
    host.limits().now().requireBelow(HostLimit.CLIENT_SESSIONS, sessionsOf(owner).size());
    host.limits().now().requireBelow(HostLimit.SESSIONS, sessions.size());
    host.limits().now().requireBelow(HostLimit.CONNECTIONS, host.orb().busyConnections());
    return new Session(owner, client, host);
  }

  private void log(Session session, String kind, String what) {
    if (session.owner().equals(SessionNames.HEALTH_CHECK)) {
      return; // each few seconds, by the monitoring system
    }
    host.journal()
        .add(
            JournalEntry.info(kind, "the session of \"" + session.owner() + "\" " + what)
                .onHost(host.hostName())
                .inSession(session.id(), session.owner()));
  }

  private void end(Session session, String why) {
    if (sessions.remove(session.id()) != null) {
      session.end();
      log(session, "session-ended", why);
    }
  }

  private void expire(Session session, String why) {
    if (sessions.remove(session.id()) != null) {
      session.expire();
      log(session, "session-ended", why);
    }
  }

  /**
   * Returns a session that is alive.
   *
   * @param user whose it must be; empty: anybody's
   * @throws NotAuthorized if it is another user's
   */
  public Optional<MechSim> find(String sessionId, String user) throws NotAuthorized {
    Entry found = sessions.get(sessionId);
    if (found == null) {
      return Optional.empty();
    }
    requireOwner(found.session().owner(), user);
    found.session().renew();
    return found.reference();
  }

  private static boolean owns(String owner, String user) {
    return user.isEmpty() || user.equals(owner);
  }

  private static void requireOwner(String owner, String user) throws NotAuthorized {
    if (!owns(owner, user)) {
      throw Caller.notTheOwner(user);
    }
  }

  /**
   * Returns a simulation, of a session that is alive or one that has ended and is kept. A run that
   * another user claims to have begun under the same id is passed over.
   *
   * @param user whose it must be; empty: anybody's
   * @throws NotFound if there is no such simulation, or no longer
   * @throws NotAuthorized if there are only other users'
   * @throws LimitExceeded if there are too many sessions to reopen it
   */
  public IMechSimRemote findSimulation(String simId, String user)
      throws NotFound, NotAuthorized, LimitExceeded {
    boolean anothers = false;
    for (Session session : allSessions()) {
      Optional<IMechSimRemote> found = session.find(simId);
      if (found.isPresent() && owns(session.owner(), user)) {
        session.renew();
        return found.get();
      }
      anothers |= found.isPresent();
    }
    Optional<RunStore.Kept> ended = host.store().find(simId);
    if (ended.isEmpty() && !anothers) {
      throw ContractErrors.notFound("there is no simulation " + simId);
    }
    RunStore.Kept kept = ended.orElseThrow(() -> Caller.notTheOwner(user));
    requireOwner(kept.identity().owner(), user);
    RunRecord run = record(kept);
    synchronized (sessions) {
      Session session = admitted(kept.identity().owner(), null);
      IMechSimRemote reference =
          session.reopen(run, kept.rows(), () -> end(session, "was ended by its client"));
      sessions.put(session.id(), new Entry(session, Optional.empty()));
      log(session, "session-opened", "was opened to take up simulation " + simId);
      return reference;
    }
  }

  private static RunRecord record(RunStore.Kept kept) throws NotFound {
    try {
      return kept.run();
    } catch (IOException e) {
      throw ContractErrors.notFound(
          "the record of simulation "
              + kept.identity().simId()
              + " cannot be read: "
              + FileErrors.reason(e));
    }
  }

  /** Returns how many sessions there are. */
  public int count() {
    return sessions.size();
  }

  /** Returns counts and sizes by name, for operators. */
  public NameValue[] statistics() {
    return ContractTypes.nameValues(
        Map.of(
            "freeDisk", Long.toString(host.store().account().freeDisk()),
            "spoolBytes", Long.toString(host.store().account().used()),
            "connections", Integer.toString(host.orb().connections()),
            "sessionsOpened", Long.toString(opened.get()),
            "completed", Long.toString(host.store().completed()),
            "failed", Long.toString(host.store().failed()),
            "cancelled", Long.toString(host.store().cancelled())));
  }

  /** Returns how many simulations are in one of these states. */
  public int count(SimState... states) {
    List<SimState> wanted = List.of(states);
    return (int) allRuns().stream().filter(run -> wanted.contains(run.state())).count();
  }

  private List<SimulationRun> allRuns() {
    return allSessions().stream().flatMap(session -> session.runs().stream()).toList();
  }

  /** Returns all simulations, also the latest ended ones, as administrators see them. */
  public List<SimSummary> summaries() {
    List<SimSummary> summaries = new ArrayList<>();
    allSessions().forEach(session -> summaries.addAll(session.summaries()));
    summaries.addAll(host.store().summaries());
    return summaries;
  }

  /**
   * Returns everything about a simulation, if there is one, with its check report if it is made.
   */
  public Optional<SimDetail> detail(String simId) {
    return detail(simId, this::reportOf);
  }

  /** Returns what is known of a simulation without computing, if there is one: no check report. */
  public Optional<SimDetail> record(String simId) {
    return detail(simId, run -> "");
  }

  private Optional<SimDetail> detail(String simId, Function<RunIdentity, String> report) {
    for (Session session : allSessions()) {
      for (SimulationRun run : session.runs()) {
        if (run.simId().equals(simId)) {
          long leaseEnd = System.currentTimeMillis() + session.leaseLeftMillis();
          return Optional.of(
              run.record()
                  .detail(
                      leaseEnd, report.apply(run.record().identity()), session.events().of(simId)));
        }
      }
    }
    return host.store()
        .known(simId)
        .map(run -> run.detail(0, report.apply(run.identity()), List.of()));
  }

  private String reportOf(RunIdentity run) {
    try {
      return reports.of(run);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }

  /**
   * Cancels a simulation on behalf of an administrator.
   *
   * @param reason reported to the client
   * @return whether there is such a simulation
   */
  public boolean kill(String simId, String reason) {
    for (Session session : allSessions()) {
      for (SimulationRun run : session.runs()) {
        if (run.simId().equals(simId)) {
          kill(session, run, reason);
          return true;
        }
      }
    }
    return false;
  }

  private void kill(Session session, SimulationRun run, String reason) {
    String text = "cancelled by the operator: " + reason;
    session.recordMessages(
        run, new Diagnostic[] {ContractTypes.information(MessageCode.CANCELLED_BY_OPERATOR, text)});
    run.stop();
    host.journal()
        .add(
            JournalEntry.warning("sim-killed", MessageCode.CANCELLED_BY_OPERATOR, text)
                .onHost(host.hostName())
                .inSession(session.id(), session.owner())
                .ofSimulation(run.simId()));
  }

  /** Returns all sessions as administrators see them, the oldest first. */
  public List<SessionSummary> sessionSummaries() {
    return sessions.values().stream()
        .filter(entry -> entry.reference().isPresent())
        .map(entry -> summary(entry.session()))
        .sorted(Comparator.comparingLong(summary -> summary.openedAt))
        .toList();
  }

  private SessionSummary summary(Session session) {
    List<SimulationRun> of = session.runs();
    return new SessionSummary(
        session.id(),
        session.owner(),
        host.hostName(),
        session.openedAt(),
        System.currentTimeMillis() + session.leaseLeftMillis(),
        (int) of.stream().filter(run -> !run.ended()).count(),
        of.size(),
        session.heldBytes());
  }

  /**
   * Ends sessions on behalf of an administrator, with their runs.
   *
   * @param sessionId of one; empty: all of the owner
   * @param owner whose; empty: anybody's, of that id
   * @param reason reported to the client
   * @return how many there were
   */
  public int endSessions(String owner, String sessionId, String reason) {
    List<Session> meant =
        allSessions().stream()
            .filter(session -> sessionId.isEmpty() || session.id().equals(sessionId))
            .filter(session -> owner.isEmpty() || session.owner().equals(owner))
            .toList();
    if (owner.isEmpty() && sessionId.isEmpty()) {
      return 0;
    }
    for (Session session : meant) {
      session.runs().stream()
          .filter(run -> !run.ended())
          .forEach(run -> kill(session, run, reason));
      expire(session, "was ended by the operator: " + reason);
    }
    return meant.size();
  }

  /** Reports to clients and operators that the host is being emptied. */
  public void announceDraining() {
    for (Session session : allSessions()) {
      session.runs().stream().filter(run -> !run.ended()).forEach(session::hostIsDraining);
    }
  }

  private void tick() {
    try {
      HostLimits limits = host.limits().now();
      host.orb().allowConnections(limits.connectionsAtAll());
      places.interruptLate();
      if (allSessions().stream()
              .filter(Session::hasActiveRun)
              .map(Session::owner)
              .distinct()
              .count()
          > 1) {
        allRuns().forEach(SimulationRun::yieldToOthers);
      }
      for (Session session : allSessions()) {
        if (session.leaseLeftMillis() < 0) {
          expire(session, "was not renewed and has ended");
        } else {
          session.runs().forEach(run -> check(session, run, limits));
        }
      }
    } catch (RuntimeException e) {
      if (!clock.isShutdown()) { // else the ORB may be closed already
        GuardedServant.record("the clock of the sessions", e);
      }
    }
  }

  private static void check(Session session, SimulationRun run, HostLimits limits) {
    run.checkLimits(limits);
    run.reportHold();
    if (run.hasProgressed()) {
      session.progressed(run);
    }
  }

  /** Ends all sessions and their runs; no thread is left. */
  @Override
  public void close() {
    clock.shutdownNow();
    allSessions().forEach(session -> expire(session, "has ended with its host"));
    queue.close();
    setUps.close();
    host.journal().close();
    try {
      queue.awaitEnd(CLOSING_MILLIS);
      callbacks.shutdown();
      callbacks.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
      clock.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    host.store().close();
  }
}
