package org.mechservice.admin;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.MechAdminPOATie;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.MechServerPOATie;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServerInfo;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceKey;
import org.mechservice.orb.ServiceOrb;
import org.omg.CORBA.IntHolder;

/** A server that says what a test wants it to say, and remembers what it was told to do. */
public final class ScriptedAdmin implements MechAdminOperations, AutoCloseable {
  /** When the script begins: two hours ago. */
  public static final long BEGAN = System.currentTimeMillis() - 7_200_000;

  private static final String[] OWNERS = {"ann", "bo", "cai"};

  private final ServiceOrb orb;
  private final ServerInfo info;
  private final Map<String, HostStatus> hosts = new LinkedHashMap<>();
  private final Map<String, SimDetail> simulations = new LinkedHashMap<>();
  private final List<ServiceEvent> events = new ArrayList<>();
  private final List<String> calls = new CopyOnWriteArrayList<>();
  private final List<Limit> limits =
      new ArrayList<>(List.of(new Limit("queue", "1", 1000, "runs that wait for a place")));
  private String placement = "least-loaded";
  private boolean draining;
  private volatile boolean forbidden;
  private volatile @Nullable CountDownLatch hanging;

  public ScriptedAdmin(String name) {
    this(name, 0);
  }

  /** Starts a server at a port of the loopback interface. */
  public ScriptedAdmin(String name, int port) {
    orb = ServiceOrb.server(new ListenAddress("127.0.0.1", port));
    info = new ServerInfo(name, "1.0", "0.1.0", BEGAN, new String[0]);
    MechServerOperations server =
        (MechServerOperations)
            Proxy.newProxyInstance(
                MechServerOperations.class.getClassLoader(),
                new Class<?>[] {MechServerOperations.class},
                (proxy, method, arguments) -> info);
    MechAdminOperations admin =
        (MechAdminOperations)
            Proxy.newProxyInstance(
                MechAdminOperations.class.getClassLoader(),
                new Class<?>[] {MechAdminOperations.class},
                (proxy, method, arguments) -> gate(method, arguments));
    orb.publish(
        Map.of(
            ServiceKey.SERVER, new MechServerPOATie(server),
            ServiceKey.ADMIN, new MechAdminPOATie(admin)));
  }

  /** Returns where it is. */
  public String address() {
    return orb.endpoint().toString();
  }

  /** Returns its port. */
  public int port() {
    return orb.endpoint().port();
  }

  /** Returns what it was told to do, in order. */
  public List<String> calls() {
    return calls;
  }

  /** Lets every call wait until it is told to go on. */
  public void hang() {
    hanging = new CountDownLatch(1);
  }

  /** Answers again. */
  public void goOn() {
    CountDownLatch wait = hanging;
    hanging = null;
    if (wait != null) {
      wait.countDown();
    }
  }

  /** Refuses everything from now on. */
  public void forbid() {
    forbidden = true;
  }

  /** Lets a call wait, or refuses it, before it reaches the script. */
  private @Nullable Object gate(Method method, Object @Nullable [] arguments) throws Throwable {
    CountDownLatch wait = hanging;
    if (wait != null) {
      wait.await();
    }
    if (forbidden) {
      throw new NotAuthorized("S-151", "not for you");
    }
    try {
      return method.invoke(this, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  /** Begins the script anew. */
  public synchronized void forget() {
    hosts.clear();
    simulations.clear();
    calls.clear();
  }

  /** Returns what it would answer. */
  public synchronized ServerReading reading() {
    return new ServerReading.Answering(
        address(),
        getStatus(),
        List.of(listHosts()),
        simulations.values().stream().map(one -> one.summary).toList());
  }

  /** Adds a host, or changes it. */
  public synchronized void host(String name, double cpuLoad, boolean reachable, String text) {
    HostInfo host = new HostInfo(name, "0.1.0", "10.0.0.2:" + name.length(), 8, 1L << 33, 4, BEGAN);
    HostLoad load = new HostLoad(2, 1, 0, cpuLoad, 3L << 28, false, new NameValue[0]);
    hosts.put(
        name,
        new HostStatus(
            host, load, reachable, reachable ? System.currentTimeMillis() : BEGAN, text));
  }

  /** Adds a simulation on a host, or changes it. */
  public synchronized SimSummary simulation(String id, String host, String model, SimState state) {
    boolean began = state != SimState.SIM_CREATED && state != SimState.SIM_QUEUED;
    double share = (37 * simulations.size() + 20) % 100 / 100.0;
    double time = state == SimState.SIM_DONE ? 3 : began ? 3 * share : 0;
    long steps = Math.round(400 * time);
    Progress progress =
        new Progress(
            id,
            state,
            began ? 0 : 1 + (int) countOn(host, SimState.SIM_QUEUED),
            time,
            0,
            3,
            steps,
            1e-3,
            5,
            12.5,
            steps / 2);
    boolean ended = state.value() >= SimState._SIM_DONE;
    SimSummary summary =
        new SimSummary(
            id,
            "x",
            host,
            model,
            OWNERS[simulations.size() % OWNERS.length],
            progress,
            BEGAN + 400_000L * simulations.size(),
            began ? BEGAN + 10 : 0,
            ended ? BEGAN + 5000 : 0,
            BEGAN + 1_000_000,
            KnownSimulation.label(state));
    FailureRecord none = new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0]);
    simulations.put(
        id,
        new SimDetail(
            summary,
            "<?xml version=\"1.0\"?>\n<MechML><!-- " + model + " --></MechML>\n",
            "{\"degreesOfFreedom\":2}",
            ended ? "{\"steps\":42}" : "",
            none,
            new CurveSample[0],
            new SimEvent[0]));
    return summary;
  }

  private long countOn(String host, SimState state) {
    return simulations.values().stream()
        .filter(one -> one.summary.hostName.equals(host) && one.summary.info.state == state)
        .count();
  }

  /** Gives every host the load that its simulations make, with no free place while one waits. */
  public synchronized void loadOfSimulations() {
    for (HostStatus host : hosts.values()) {
      host.load.running = (int) countOn(host.info.name, SimState.SIM_RUNNING);
      host.load.queued = (int) countOn(host.info.name, SimState.SIM_QUEUED);
      host.load.sessions = host.load.running + host.load.queued;
      if (host.load.queued > 0) {
        host.info.capacity = host.load.running;
      }
    }
  }

  /** Lets all that run make a step. */
  public synchronized void advance() {
    for (SimDetail one : simulations.values()) {
      Progress info = one.summary.info;
      if (info.state == SimState.SIM_RUNNING) {
        info.simTime = (info.simTime + 0.01) % info.endTime;
        info.stepsDone++;
      }
    }
  }

  /** Adds a simulation that has failed. */
  public synchronized SimSummary failed(String id, String host, String model, String text) {
    SimSummary summary = simulation(id, host, model, SimState.SIM_FAILED);
    summary.text = "N-003 " + text;
    StepTried[] steps = {new StepTried(1.5, 1e-9, 1, 7.5)};
    detail(id).failed =
        new FailureRecord("N-003", text, 1.5, 1e-9, 1, "joint knee", "Try ode15s.", steps);
    return summary;
  }

  private SimDetail detail(String id) {
    return Objects.requireNonNull(simulations.get(id));
  }

  /** Sets the check report of a simulation; empty: it is not made yet. */
  public synchronized void checkReport(String id, String json) {
    detail(id).checkReportJson = json;
  }

  /**
   * Puts samples up to the time reached into a simulation's curves: a swing in every one of them.
   */
  public synchronized void curves(String id, int count) {
    Progress info = detail(id).summary.info;
    CurveSample[] samples = new CurveSample[count];
    for (int i = 0; i < count; i++) {
      double t = info.simTime * i / (count - 1);
      samples[i] =
          new CurveSample(
              BEGAN + 50L * i,
              t,
              1e-3 * Math.exp(2 * Math.sin(5 * t)),
              3 + (int) Math.round(2 * Math.sin(2 * t)),
              1e-6 * t * t * Math.cos(3 * t),
              1e-9 * (1.5 + Math.sin(9 * t)));
    }
    detail(id).curves = samples;
    info.stepSize = samples[count - 1].stepSize;
    info.stepOrder = samples[count - 1].stepOrder;
  }

  /** Puts samples into a simulation's curves that scatter widely, with one peak. */
  public synchronized void noise(String id, int count) {
    CurveSample[] samples = new CurveSample[count];
    for (int i = 0; i < count; i++) {
      double scatter = Math.sin(12.9898 * i * i);
      samples[i] =
          new CurveSample(
              BEGAN + 50L * i,
              3.0 * i / count,
              i == count / 3 ? 1e-7 : 1e-3 * Math.exp(scatter),
              3 + (int) Math.round(scatter),
              1e-6 * scatter,
              1e-9 * (1.5 + scatter));
    }
    detail(id).curves = samples;
  }

  /** Tells that something happened. */
  public synchronized void happened(String kind, Severity level, String code, String text) {
    events.add(
        new ServiceEvent(
            events.size() + 1L, BEGAN + events.size(), kind, level, code, "", "", "", "ann", text));
    notifyAll();
  }

  @Override
  public synchronized ServerStatus getStatus() {
    return new ServerStatus(
        info,
        draining,
        hosts.size(),
        2,
        count(SimState.SIM_RUNNING),
        count(SimState.SIM_QUEUED),
        new NameValue[0]);
  }

  private int count(SimState state) {
    return (int)
        simulations.values().stream().filter(one -> one.summary.info.state == state).count();
  }

  @Override
  public synchronized HostStatus[] listHosts() {
    return hosts.values().toArray(HostStatus[]::new);
  }

  @Override
  public SessionSummary[] listSessions() {
    return new SessionSummary[] {
      new SessionSummary("3f2a-1", "ann", "h1", 0, 0, 1, 2, 300),
      new SessionSummary("77aa-2", "bob", "h1", 0, 0, 0, 0, 0)
    };
  }

  @Override
  public int endSessions(String owner, String sessionId, String reason) {
    calls.add("endSessions " + owner + sessionId + " " + reason);
    return 1;
  }

  @Override
  public synchronized SimSummary[] listSimulations(int offset, int maxCount, IntHolder total) {
    total.value = simulations.size();
    return simulations.values().stream()
        .map(one -> one.summary)
        .skip(offset)
        .limit(maxCount)
        .toArray(SimSummary[]::new);
  }

  @Override
  public synchronized SimDetail showSimulation(String simId) throws NotFound {
    return Optional.ofNullable(simulations.get(simId))
        .orElseThrow(() -> new NotFound("S-011", "there is no simulation " + simId));
  }

  @Override
  public synchronized ServiceEvent[] events(long afterSeqNo, int maxCount, int waitMillis) {
    long deadline = System.nanoTime() + waitMillis * 1_000_000L;
    try {
      long left = waitMillis;
      while (events.size() <= afterSeqNo && left > 0) {
        wait(left);
        left = (deadline - System.nanoTime()) / 1_000_000;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return events.stream()
        .filter(event -> event.seqNo > afterSeqNo)
        .limit(maxCount)
        .toArray(ServiceEvent[]::new);
  }

  @Override
  public LogLine[] logs(String hostName, long since, int maxCount) {
    return new LogLine[] {
      new LogLine(BEGAN, "INFO", hostName.isEmpty() ? info.serverName : hostName, "has started")
    };
  }

  @Override
  public void killSimulation(String simId, String reason) throws NotFound {
    showSimulation(simId).summary.info.state = SimState.SIM_CANCELLED;
    calls.add("kill " + simId + " " + reason);
  }

  @Override
  public synchronized Limit[] getLimits(String hostName) {
    return limits.toArray(Limit[]::new);
  }

  @Override
  public synchronized void setLimits(String hostName, Limit[] values) throws InvalidOption {
    for (Limit value : values) {
      if (value.value < 0) {
        throw new InvalidOption("S-015", value.name + " cannot be " + value.value, value.name);
      }
      limits.replaceAll(
          old ->
              old.name.equals(value.name)
                  ? new Limit(old.name, old.unit, value.value, old.text)
                  : old);
      calls.add("limit " + hostName + " " + value.name + "=" + value.value);
    }
  }

  @Override
  public synchronized String getPlacement() {
    return placement;
  }

  @Override
  public synchronized void setPlacement(String policy) {
    placement = policy;
    calls.add("placement " + policy);
  }

  @Override
  public void drain(String hostName) {
    setDraining(hostName, true);
  }

  @Override
  public void undrain(String hostName) {
    setDraining(hostName, false);
  }

  private synchronized void setDraining(String hostName, boolean drain) {
    if (hostName.isEmpty()) {
      draining = drain;
    } else {
      Objects.requireNonNull(hosts.get(hostName)).load.draining = drain;
    }
    calls.add((drain ? "drain " : "undrain ") + hostName);
  }

  @Override
  public void shutdownServer(int graceSeconds) {
    calls.add("shutdown " + graceSeconds);
  }

  @Override
  public void close() {
    goOn();
    orb.close();
  }
}
