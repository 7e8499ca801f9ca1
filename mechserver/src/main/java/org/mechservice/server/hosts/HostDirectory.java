package org.mechservice.server.hosts;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.connection.OutboundAllowList;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.BAD_OPERATION;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;

/**
 * The hosts of a server. Drops those that do not renew or cannot be connected to any more, and
 * remembers the latest of them for administrators.
 */
public final class HostDirectory implements AutoCloseable {
  /** So many times as long as for others. */
  private static final int OWN_PATIENCE = 15;

  private static final int DROPPED_KEPT = 20;
  private static final int EVENTS_AT_ONCE = 1000;
  private static final int READ_AT_ONCE = 8;

  /** Largest age of the kept state of running runs, ns. */
  private static final long LIST_AGE_NANOS = TimeUnit.SECONDS.toNanos(2);

  private final ServerTuning tuning;
  private final OutboundAllowList outbound;
  private final Journal journal;
  private final RunRegistry runs;
  private final HostCalls calls;
  private final Map<String, RegisteredHost> hosts = new ConcurrentHashMap<>();
  private final Deque<RegisteredHost> dropped = new ArrayDeque<>();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(HostCalls.named("hosts"));

  public HostDirectory(ServerTuning tuning, OutboundAllowList outbound, Journal journal) {
    this.tuning = tuning;
    this.outbound = outbound;
    this.journal = journal;
    runs = new RunRegistry(journal);
    calls = new HostCalls(tuning.hostAnswer());
    long period = tuning.hostCheck().toMillis();
    var unused = clock.scheduleWithFixedDelay(this::check, period, period, TimeUnit.MILLISECONDS);
  }

  public RunRegistry runs() {
    return runs;
  }

  public HostCalls calls() {
    return calls;
  }

  ServerTuning tuning() {
    return tuning;
  }

  /** Takes a host in, in place of an earlier one of its name. */
  public void add(RegisteredHost host) {
    RegisteredHost earlier = hosts.put(host.name(), host);
    if (earlier != null) {
      earlier.removed();
    }
    synchronized (dropped) {
      dropped.removeIf(gone -> gone.name().equals(host.name()));
    }
    if (!host.own()) {
      journal.add(
          JournalEntry.info(
                  "host-joined", "host " + host.name() + " joined from " + host.endpoint())
              .onHost(host.name()));
    }
  }

  public Optional<RegisteredHost> find(String name) {
    return Optional.ofNullable(hosts.get(name));
  }

  /** Returns the hosts, by name. */
  public List<RegisteredHost> all() {
    return hosts.values().stream().sorted(Comparator.comparing(RegisteredHost::name)).toList();
  }

  /** The state of a host as it reports it. */
  private record News(
      HostLoad load, List<ServiceEvent> events, Optional<SimSummary[]> runs, long askedAt) {}

  /**
   * Requests load, events and runs of all hosts, and waits a short time for the answers. A host
   * that already owes an answer is skipped: its last known state stays.
   */
  public void refresh() {
    List<Future<?>> asked = new ArrayList<>();
    for (RegisteredHost host : all()) {
      if (host.reachable() && !host.isOverdue(tuning.hostWait())) {
        asked.add(calls.begin(host, question(host, /* withRuns= */ true), this::receive));
      }
    }
    long deadline = System.nanoTime() + tuning.hostWait().toNanos();
    for (Future<?> answer : asked) {
      await(answer, deadline);
    }
    noteSilent();
  }

  private static void await(Future<?> answer, long deadline) {
    try {
      answer.get(Math.max(0, deadline - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      // The last known state stays.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException e) {
      GuardedServant.record("the answer of a host", e);
    }
  }

  private HostCalls.Query<News> question(RegisteredHost known, boolean withRuns) {
    return host -> {
      makePendingCalls(host, known);
      long askedAt = System.nanoTime();
      HostLoad load = host.getLoad();
      List<ServiceEvent> events = List.of(host.events(known.lastEvent(), EVENTS_AT_ONCE, 0));
      boolean list =
          withRuns
              || events.stream().anyMatch(event -> !event.simId.isEmpty())
              || runs.outdated(known.name(), load.running, LIST_AGE_NANOS);
      return new News(
          load, events, list ? Optional.of(host.listSimulations()) : Optional.empty(), askedAt);
    };
  }

  private static void makePendingCalls(MechSimHostOperations host, RegisteredHost known)
      throws UserException {
    for (HostCalls.Query<?> owed : known.takePendingCalls()) {
      try {
        var unused = owed.query(host);
      } catch (SystemException e) {
        known.callLater(owed);
        throw e;
      }
    }
  }

  private News follow(RegisteredHost host) throws UserException {
    News news = question(host, /* withRuns= */ false).query(host.host());
    readOn(host);
    return news;
  }

  private void receive(RegisteredHost host, HostCalls.Answer<News> answer) {
    if (answer.value().isPresent()) {
      News news = answer.value().get();
      host.answered(news.load(), news.askedAt());
      takeOver(host, news);
    } else {
      failed(host, answer.failure(), answer.connectionLost());
    }
  }

  private void takeOver(RegisteredHost host, News news) {
    synchronized (host) { // two threads may have called at once
      if (host.isDropped()) {
        return;
      }
      for (ServiceEvent event : news.events()) {
        if (event.seqNo > host.lastEvent()) {
          host.tookOver(event.seqNo);
          journal.addOfHost(event);
          runs.follow(event);
        }
      }
      news.runs().ifPresent(listed -> runs.listed(host.name(), listed, news.askedAt()));
    }
  }

  /**
   * Fetches the records of some runs while their host answers, to have them when it is gone. Those
   * of the server's own process would go with it.
   */
  private void readOn(RegisteredHost host) throws UserException {
    if (host.own()) {
      runs.leaveUnread(host.name());
      return;
    }
    for (int i = 0; i < READ_AT_ONCE; i++) {
      Optional<String> next = runs.takeUnread(host.name());
      if (next.isEmpty()) {
        return;
      }
      try {
        runs.read(recordOf(next.get(), host.host()));
      } catch (NotFound e) {
        // Its client has destroyed it already.
      } catch (SystemException e) {
        runs.notRead(host.name(), next.get());
        throw e;
      }
    }
  }

  private static SimDetail recordOf(String simId, MechSimHostOperations host) throws NotFound {
    try {
      return host.recordOf(simId);
    } catch (BAD_OPERATION e) {
      return host.showSimulation(simId); // a host of the contract before 1.5
    }
  }

  /**
   * Calls all hosts that are not silent at once, until one has an answer.
   *
   * @throws NotAuthorized if none has, and one refuses it to the user
   */
  public <T> Optional<T> search(HostCalls.Query<T> question) throws NotAuthorized {
    return calls.firstAnswer(
        all().stream().filter(RegisteredHost::reachable).toList(),
        question,
        (host, answer) -> failed(host, answer.failure(), answer.connectionLost()));
  }

  /** Calls all hosts at once; hosts that do not answer are called again when they do. */
  void callAll(HostCalls.Query<Boolean> message) {
    List<Future<?>> told = new ArrayList<>();
    for (RegisteredHost host : all()) {
      if (host.reachable()) {
        told.add(
            calls.begin(
                host,
                message,
                (to, answer) -> {
                  if (!answer.failure().isEmpty()) {
                    to.callLater(message);
                    failed(to, answer.failure(), answer.connectionLost());
                  }
                }));
      } else {
        host.callLater(message);
      }
    }
    long deadline = System.nanoTime() + tuning.hostAnswer().toNanos();
    told.forEach(answer -> await(answer, deadline));
  }

  /** Notes that a host did not answer; one that cannot be connected to is dropped. */
  void failed(RegisteredHost host, String why, boolean connectionLost) {
    host.silent(why);
    if (connectionLost && !host.own()) {
      drop(host, "its connection failed: " + why);
    }
  }

  /** The host in this process is there, however busy the machine is; if it hangs, it is told. */
  private void noteSilent() {
    for (RegisteredHost host : all()) {
      Duration patience = tuning.hostAnswer().multipliedBy(host.own() ? OWN_PATIENCE : 1);
      if (host.reachable() && host.isOverdue(patience)) {
        host.silent(HostCalls.late(patience));
      }
    }
  }

  /** Returns a text that names the silent hosts, for error messages; empty: none. */
  public String silentHosts() {
    List<String> silent =
        all().stream().filter(host -> !host.reachable()).map(RegisteredHost::name).toList();
    return silent.isEmpty()
        ? ""
        : "; it may be on " + String.join(", ", silent) + ", which does not answer: try again";
  }

  private void drop(RegisteredHost host, String why) {
    if (hosts.remove(host.name(), host)) {
      host.removed();
      outbound.forbid(host.endpoint().host(), host.endpoint().port());
      host.dropped(why);
      synchronized (dropped) {
        dropped.addFirst(host);
        if (dropped.size() > DROPPED_KEPT) {
          dropped.removeLast();
        }
      }
      journal.add(
          JournalEntry.warning(
                  "host-lost", MessageCode.HOST_DROPPED, "host " + host.name() + " dropped: " + why)
              .onHost(host.name()));
      runs.removeHost(host.name(), "was lost");
    }
  }

  /** Takes a host that signs off out. */
  void signOff(RegisteredHost host) {
    if (hosts.remove(host.name(), host)) {
      host.removed();
      outbound.forbid(host.endpoint().host(), host.endpoint().port());
      host.dropped("it signed off");
      journal.add(
          JournalEntry.info("host-left", "host " + host.name() + " signed off")
              .onHost(host.name()));
      runs.removeHost(host.name(), "signed off");
    }
  }

  /** Returns the hosts, and those lately dropped, as administrators see them. */
  public List<HostStatus> statuses() {
    List<HostStatus> statuses =
        new ArrayList<>(all().stream().map(RegisteredHost::status).toList());
    synchronized (dropped) {
      dropped.forEach(host -> statuses.add(host.status()));
    }
    return statuses;
  }

  /** Never waits for a host: one that hangs holds up none of the others. */
  private void check() {
    try {
      noteSilent();
      for (RegisteredHost host : all()) {
        if (host.expired(tuning.hostLease())) {
          drop(host, "it has not renewed for " + tuning.hostLease().toMillis() * 1e-3 + " s");
        } else if (!host.isOverdue(tuning.hostCheck())) {
          var unused = calls.begin(host, asked -> follow(host), this::receive);
        }
      }
    } catch (RuntimeException e) {
      if (!clock.isShutdown()) { // else the calls to the hosts are closed already
        GuardedServant.record("the clock of the hosts", e);
      }
    }
  }

  @Override
  public void close() {
    clock.shutdownNow();
    calls.close();
    try {
      clock.awaitTermination(tuning.hostAnswer().toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
