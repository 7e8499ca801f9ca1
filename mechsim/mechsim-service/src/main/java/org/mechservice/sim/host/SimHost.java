package org.mechservice.sim.host;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.sim.service.contract.AccessRights;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.sim.service.contract.ShortText;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.session.SessionTable;
import org.mechservice.sim.service.session.WarmUp;
import org.mechservice.solver.api.Solver;

/**
 * The servant of a host: opens sessions and answers operators. A host process has one, and so has a
 * server that runs simulations itself.
 */
public final class SimHost implements MechSimHostOperations, AutoCloseable {
  private static final long GRACE_CHECK_MILLIS = 100;

  private final ServiceOrb orb;
  private final HostOptions options;
  private final CurrentLimits limits;
  private final SessionTable sessions;
  private final Journal journal;
  private final DenialLog denials;
  private final WarmUp warmUp;
  private final Runnable shutdown;
  private final long startedAt = System.currentTimeMillis();
  private final AtomicBoolean draining = new AtomicBoolean();

  private final MachineLoad processors = MachineLoad.ofThisMachine();

  /** Text for operators about user classes; the sandbox is known after the warm-up. */
  private volatile String userCode;

  /**
   * Opens a host without sessions.
   *
   * @param orb serves its sessions
   * @param solver runs simulations
   * @param shutdown closes what the host is part of
   * @throws IllegalArgumentException with code S-114 if the spool folder cannot be used
   */
  public SimHost(ServiceOrb orb, HostOptions options, Solver solver, Runnable shutdown) {
    this(orb, options, new CurrentLimits(options.limits()), solver, shutdown);
  }

  /**
   * Opens a host that shares its limits with its server.
   *
   * @param limits current limits; those of the options are ignored
   */
  public SimHost(
      ServiceOrb orb, HostOptions options, CurrentLimits limits, Solver solver, Runnable shutdown) {
    this.orb = orb;
    this.options = options;
    this.limits = limits;
    this.shutdown = shutdown;
    userCode = options.userCode() == UserCodePolicy.REFUSED ? "refused" : "allowed";
    journal = new Journal(options.name());
    denials = new DenialLog(journal);
    sessions =
        new SessionTable(
            orb,
            options.name(),
            options.capacity(),
            limits,
            options.spool(),
            solver,
            journal,
            denials,
            options.userCode());
    warmUp = new WarmUp(orb, solver, sessions.setUps());
  }

  /** Returns the host as servers call it; without TLS anybody on this machine may. */
  MechSimHostOperations forServers() {
    return GuardedServant.of(MechSimHostOperations.class, this, AccessRights.toServe(denials));
  }

  /**
   * Begins to load classes for the first client; clients are served meanwhile. Finds out which wall
   * this machine has for classes of users, if they may run here.
   */
  public void warmUp() {
    warmUp.begin();
    if (options.userCode() != UserCodePolicy.REFUSED) {
      Confinement wall = Confinement.ofThisMachine();
      userCode = options.userCode().text(wall);
      journal.log(
          wall.stands() ? Severity.SEV_INFO : Severity.SEV_WARNING,
          "classes of users are " + userCode);
    }
  }

  /** Returns counts and sizes, whether classes of users run here, and how long this is trusted. */
  private NameValue[] statistics() {
    List<NameValue> all = new ArrayList<>(List.of(sessions.statistics()));
    all.add(new NameValue("userCode", userCode));
    all.add(new NameValue("processLoad", Double.toString(processors.now().process())));
    orb.identity()
        .ifPresent(
            own ->
                all.add(
                    new NameValue(
                        "certificateExpires", Long.toString(own.expires().toEpochMilli()))));
    return all.toArray(NameValue[]::new);
  }

  /** Returns the solver of this process. */
  public static Solver installedSolver() {
    return ServiceLoader.load(Solver.class, SimHost.class.getClassLoader())
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("no solver on the class path"));
  }

  @Override
  public HostInfo getInfo() {
    Runtime machine = Runtime.getRuntime();
    return new HostInfo(
        options.name(),
        ServiceVersion.CURRENT,
        orb.endpoint().toString(),
        machine.availableProcessors(),
        machine.maxMemory(),
        options.capacity(),
        startedAt);
  }

  @Override
  public HostLoad getLoad() {
    Runtime machine = Runtime.getRuntime();
    return new HostLoad(
        sessions.count(),
        sessions.count(SimState.SIM_RUNNING, SimState.SIM_PAUSED),
        sessions.count(SimState.SIM_QUEUED),
        processors.now().machine(),
        machine.totalMemory() - machine.freeMemory(),
        draining.get(),
        statistics());
  }

  @Override
  public MechSim createSession(String clientName, @Nullable IMechClient client)
      throws LimitExceeded {
    if (draining.get()) {
      throw ContractErrors.noPlace(
          "host " + options.name() + " is being emptied and takes no new sessions");
    }
    return sessions.open(ShortText.name(clientName), client);
  }

  @Override
  public MechSim findSession(String sessionId, String user) throws NotFound, NotAuthorized {
    return sessions
        .find(sessionId, user)
        .orElseThrow(() -> ContractErrors.notFound("there is no session " + sessionId));
  }

  @Override
  public IMechSimRemote findSimulation(String simId, String user)
      throws NotFound, NotAuthorized, LimitExceeded {
    return sessions.findSimulation(simId, user);
  }

  @Override
  public SessionSummary[] listSessions() {
    return sessions.sessionSummaries().toArray(SessionSummary[]::new);
  }

  @Override
  public int endSessions(String owner, String sessionId, String reason) {
    return sessions.endSessions(owner, sessionId, reason);
  }

  @Override
  public SimSummary[] listSimulations() {
    return sessions.summaries().toArray(SimSummary[]::new);
  }

  @Override
  public SimDetail showSimulation(String simId) throws NotFound {
    return sessions.detail(simId).orElseThrow(() -> noSimulation(simId));
  }

  @Override
  public SimDetail recordOf(String simId) throws NotFound {
    return sessions.record(simId).orElseThrow(() -> noSimulation(simId));
  }

  private NotFound noSimulation(String simId) {
    return ContractErrors.notFound(
        "there is no simulation " + simId + " on host " + options.name());
  }

  @Override
  public void killSimulation(String simId, String reason) throws NotFound {
    if (!sessions.kill(simId, reason)) {
      throw noSimulation(simId);
    }
  }

  @Override
  public LogLine[] logs(long since, int maxCount) {
    return journal.since(since, maxCount);
  }

  @Override
  public ServiceEvent[] events(long afterSeqNo, int maxCount, int waitMillis) {
    return journal.eventsAfter(
        afterSeqNo,
        Integer.toUnsignedLong(maxCount),
        Math.min(Integer.toUnsignedLong(waitMillis), MAX_WAIT_MILLIS.value));
  }

  @Override
  public Limit[] getLimits() {
    return limits.now().toLimits();
  }

  @Override
  public void setLimits(Limit[] values) throws InvalidOption {
    limits.change(values);
    for (Limit limit : values) {
      record("limit-set", "limit " + limit.name + " is " + limit.value + " now");
    }
  }

  private void record(String kind, String text) {
    journal.add(JournalEntry.info(kind, text).onHost(options.name()));
  }

  @Override
  public void drain() {
    if (draining.compareAndSet(false, true)) {
      record("drained", "takes no new sessions");
      sessions.announceDraining();
    }
  }

  @Override
  public void undrain() {
    if (draining.compareAndSet(true, false)) {
      record("undrained", "takes new sessions again");
    }
  }

  @Override
  public void shutdownHost(int graceSeconds) {
    drain();
    Thread closing =
        new Thread(
            () -> {
              awaitIdle(Integer.toUnsignedLong(graceSeconds));
              shutdown.run();
            },
            "mechservice-shutdown");
    closing.setDaemon(true);
    closing.start();
  }

  /**
   * Waits until no simulation runs or waits, or the time is over.
   *
   * @param seconds longest wait, s
   */
  public void awaitIdle(long seconds) {
    long deadline = System.nanoTime() + seconds * 1_000_000_000;
    try {
      while (busy() && System.nanoTime() < deadline) {
        Thread.sleep(GRACE_CHECK_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean busy() {
    return sessions.count(SimState.SIM_RUNNING, SimState.SIM_PAUSED, SimState.SIM_QUEUED) > 0;
  }

  /** Ends all sessions. */
  @Override
  public void close() {
    warmUp.close();
    sessions.close();
  }
}
