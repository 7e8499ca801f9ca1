package org.mechservice.sim.host;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.ServiceLoader;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.sim.service.HostLimits;
import org.mechservice.sim.service.Journal;
import org.mechservice.sim.service.Refusal;
import org.mechservice.sim.service.SessionTable;
import org.mechservice.solver.api.Solver;

/**
 * The place MechSims live in: a host process has one, and so has a server that runs simulations
 * itself.
 */
public final class SimHost implements MechSimHostOperations, AutoCloseable {
  private static final long GRACE_CHECK_MILLIS = 100;

  private final ServiceOrb orb;
  private final String name;
  private final int capacity;
  private final SessionTable sessions;
  private final Journal journal;
  private final Runnable shutdown;
  private final long startedAt = System.currentTimeMillis();
  private final AtomicBoolean draining = new AtomicBoolean();

  /**
   * Opens a host without sessions.
   *
   * @param orb serves its sessions
   * @param name its name at the server
   * @param capacity simulations it runs at once
   * @param solver runs them
   * @param shutdown closes what the host is part of
   */
  public SimHost(
      ServiceOrb orb,
      String name,
      int capacity,
      HostLimits limits,
      Solver solver,
      Runnable shutdown) {
    this.orb = orb;
    this.name = name;
    this.capacity = capacity;
    this.shutdown = shutdown;
    journal = new Journal(name);
    sessions = new SessionTable(orb, name, capacity, limits, solver, journal);
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
        name,
        ServiceVersion.CURRENT,
        orb.endpoint().toString(),
        machine.availableProcessors(),
        machine.maxMemory(),
        capacity,
        startedAt);
  }

  @Override
  public HostLoad getLoad() {
    Runtime machine = Runtime.getRuntime();
    return new HostLoad(
        sessions.count(),
        sessions.count(SimState.SIM_RUNNING, SimState.SIM_PAUSED),
        sessions.count(SimState.SIM_QUEUED),
        cpuLoad(),
        machine.totalMemory() - machine.freeMemory(),
        draining.get());
  }

  /** Returns the share of the machine's processors in use, 0 to 1; 0 if it is not known. */
  private static double cpuLoad() {
    return ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
        ? Math.max(0, system.getCpuLoad())
        : 0;
  }

  @Override
  public MechSim createSession(String clientName, @Nullable IMechClient client)
      throws LimitExceeded {
    if (draining.get()) {
      throw Refusal.noPlace("host " + name + " is being emptied and takes no new sessions");
    }
    return sessions.open(clientName, client);
  }

  @Override
  public MechSim findSession(String sessionId) throws NotFound {
    return sessions
        .find(sessionId)
        .orElseThrow(() -> Refusal.notFound("there is no session " + sessionId));
  }

  @Override
  public SimSummary[] listSimulations() {
    return sessions.summaries().toArray(SimSummary[]::new);
  }

  @Override
  public SimDetail showSimulation(String simId) throws NotAvailable {
    throw Refusal.notAvailable(
        "details of a simulation are not in this version; listSimulations shows its progress");
  }

  @Override
  public void killSimulation(String simId, String reason) throws NotFound {
    if (!sessions.kill(simId, reason)) {
      throw Refusal.notFound("there is no simulation " + simId + " on host " + name);
    }
  }

  @Override
  public LogLine[] logs(long since, int maxCount) {
    return journal.since(since, maxCount);
  }

  /** Returns what this host allows. */
  public Limit[] limits() {
    return sessions.limits().toLimits();
  }

  @Override
  public void setLimits(Limit[] values) throws NotAvailable {
    throw Refusal.notAvailable("changing limits is not in this version");
  }

  @Override
  public void drain() {
    draining.set(true);
    journal.info("takes no new sessions");
  }

  @Override
  public void undrain() {
    draining.set(false);
    journal.info("takes new sessions again");
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
    sessions.close();
  }
}
