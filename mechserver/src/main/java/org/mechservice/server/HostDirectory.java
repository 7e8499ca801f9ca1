package org.mechservice.server;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.OutboundAllowList;
import org.mechservice.sim.service.Happening;
import org.mechservice.sim.service.Journal;

/**
 * The hosts of a server. Drops those that do not renew or cannot be connected to any more, and
 * remembers the latest of them for administrators.
 */
final class HostDirectory implements AutoCloseable {
  private static final int DROPPED_KEPT = 20;
  private static final int EVENTS_AT_ONCE = 1000;

  private final ServerTuning tuning;
  private final OutboundAllowList outbound;
  private final Journal journal;
  private final LostRuns lostRuns;
  private final HostCalls calls;
  private final Map<String, KnownHost> hosts = new ConcurrentHashMap<>();
  private final Deque<KnownHost> dropped = new ArrayDeque<>();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(HostCalls.named("hosts"));

  HostDirectory(ServerTuning tuning, OutboundAllowList outbound, Journal journal) {
    this.tuning = tuning;
    this.outbound = outbound;
    this.journal = journal;
    lostRuns = new LostRuns(journal);
    calls = new HostCalls(tuning.hostAnswer());
    long period = tuning.hostCheck().toMillis();
    var unused = clock.scheduleWithFixedDelay(this::check, period, period, TimeUnit.MILLISECONDS);
  }

  LostRuns lostRuns() {
    return lostRuns;
  }

  HostCalls calls() {
    return calls;
  }

  ServerTuning tuning() {
    return tuning;
  }

  /** Takes a host in, in place of an earlier one of its name. */
  void add(KnownHost host) {
    hosts.put(host.name(), host);
    synchronized (dropped) {
      dropped.removeIf(gone -> gone.name().equals(host.name()));
    }
    if (!host.own()) {
      journal.tell(
          Happening.info("host-joined", "host " + host.name() + " joined from " + host.endpoint())
              .onHost(host.name()));
    }
  }

  Optional<KnownHost> find(String name) {
    return Optional.ofNullable(hosts.get(name));
  }

  /** Returns the hosts, by name. */
  List<KnownHost> all() {
    return hosts.values().stream().sorted(Comparator.comparing(KnownHost::name)).toList();
  }

  /** What a host tells when it is asked how it is. */
  private record News(HostLoad load, List<ServiceEvent> events) {}

  /** Asks all hosts for their load and what happened, at once; returns those that answered. */
  List<KnownHost> refresh() {
    long askedAt = System.nanoTime();
    Map<KnownHost, News> news =
        askAll((host, known) -> new News(host.getLoad(), eventsOf(host, known)));
    news.forEach(
        (host, said) -> {
          host.answered(said.load(), askedAt);
          takeOver(host, said.events());
        });
    return List.copyOf(news.keySet());
  }

  private static List<ServiceEvent> eventsOf(MechSimHostOperations host, KnownHost known) {
    return List.of(host.events(known.lastEvent(), EVENTS_AT_ONCE, 0));
  }

  private void takeOver(KnownHost host, List<ServiceEvent> events) {
    synchronized (host) { // two may have asked at once
      for (ServiceEvent event : events) {
        if (event.seqNo > host.lastEvent()) {
          host.tookOver(event.seqNo);
          journal.retell(event);
          lostRuns.follow(event);
        }
      }
    }
  }

  /** Asks all hosts at once; who cannot be connected to is dropped. */
  <T> Map<KnownHost, T> askAll(HostCalls.Question<T> question) {
    return askAll((host, known) -> question.ask(host));
  }

  private <T> Map<KnownHost, T> askAll(HostCalls.QuestionToKnown<T> question) {
    Map<KnownHost, T> answers = new LinkedHashMap<>();
    calls
        .askAll(all(), question)
        .forEach(
            (host, answer) -> {
              if (answer.value().isPresent()) {
                answers.put(host, answer.value().get());
              } else {
                failed(host, answer.failure(), answer.connectionLost());
              }
            });
    return answers;
  }

  /** Notes that a host did not answer; one that cannot be connected to is dropped. */
  void failed(KnownHost host, String why, boolean connectionLost) {
    host.silent(why);
    if (connectionLost && !host.own()) {
      drop(host, "its connection failed: " + why);
    }
  }

  private void drop(KnownHost host, String why) {
    if (hosts.remove(host.name(), host)) {
      outbound.forbid(host.endpoint().host(), host.endpoint().port());
      host.dropped(why);
      synchronized (dropped) {
        dropped.addFirst(host);
        if (dropped.size() > DROPPED_KEPT) {
          dropped.removeLast();
        }
      }
      journal.tell(
          Happening.warning("host-lost", "S-019", "host " + host.name() + " dropped: " + why)
              .onHost(host.name()));
      lostRuns.lostWith(host.name());
    }
  }

  /** Takes a host that signs off out. */
  void signOff(KnownHost host) {
    if (hosts.remove(host.name(), host)) {
      outbound.forbid(host.endpoint().host(), host.endpoint().port());
      journal.tell(
          Happening.info("host-left", "host " + host.name() + " signed off").onHost(host.name()));
    }
  }

  /** Returns the hosts, and those lately dropped, as administrators see them. */
  List<HostStatus> statuses() {
    List<HostStatus> statuses = new ArrayList<>(all().stream().map(KnownHost::status).toList());
    synchronized (dropped) {
      dropped.forEach(host -> statuses.add(host.status()));
    }
    return statuses;
  }

  private void check() {
    try {
      for (KnownHost host : all()) {
        if (host.expired(tuning.hostLease())) {
          drop(host, "it has not renewed for " + tuning.hostLease().toMillis() * 1e-3 + " s");
        }
      }
      refresh();
    } catch (RuntimeException e) {
      GuardedServant.record("the clock of the hosts", e);
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
