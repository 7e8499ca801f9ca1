package org.mechservice.server.admin;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.FarmLimits;
import org.mechservice.server.hosts.HostCalls;
import org.mechservice.server.hosts.HostDirectory;
import org.mechservice.server.hosts.MechServerServant;
import org.mechservice.server.hosts.Placement;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.server.hosts.RegisteredHost;
import org.mechservice.server.hosts.RunRegistry;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.omg.CORBA.IntHolder;

/**
 * The servant of the interface for administrators. Every answer comes in time: silent hosts are
 * left out of it.
 */
public final class MechAdminServant implements MechAdminOperations {
  /** Ends the server. */
  public interface Shutdown {
    void within(long graceSeconds);
  }

  private final MechServerServant server;
  private final HostDirectory directory;
  private final Placement placement;
  private final FarmLimits limits;
  private final Journal journal;
  private final Optional<TlsIdentity> identity;
  private final Shutdown shutdown;

  public MechAdminServant(
      MechServerServant server,
      HostDirectory directory,
      Placement placement,
      FarmLimits limits,
      Journal journal,
      Optional<TlsIdentity> identity,
      Shutdown shutdown) {
    this.server = server;
    this.directory = directory;
    this.placement = placement;
    this.limits = limits;
    this.journal = journal;
    this.identity = identity;
    this.shutdown = shutdown;
  }

  @Override
  public ServerStatus getStatus() {
    directory.refresh();
    List<HostLoad> loads = directory.all().stream().map(RegisteredHost::load).toList();
    return new ServerStatus(
        server.getInfo(),
        server.draining(),
        directory.all().size(),
        loads.stream().mapToInt(load -> load.sessions).sum(),
        loads.stream().mapToInt(load -> load.running).sum(),
        loads.stream().mapToInt(load -> load.queued).sum(),
        statistics());
  }

  private NameValue[] statistics() {
    Runtime machine = Runtime.getRuntime();
    List<NameValue> all = new ArrayList<>();
    all.add(
        new NameValue(
            "uptimeSeconds",
            Long.toString((System.currentTimeMillis() - server.getInfo().startedAt) / 1000)));
    all.add(
        new NameValue("heapBytes", Long.toString(machine.totalMemory() - machine.freeMemory())));
    identity.ifPresent(
        own ->
            all.add(
                new NameValue("certificateExpires", Long.toString(own.expires().toEpochMilli()))));
    return all.toArray(NameValue[]::new);
  }

  @Override
  public HostStatus[] listHosts() {
    directory.refresh();
    return directory.statuses().toArray(HostStatus[]::new);
  }

  @Override
  public SimSummary[] listSimulations(int offset, int maxCount, IntHolder total) {
    directory.refresh();
    RunRegistry runs = directory.runs();
    List<SimSummary> all = new ArrayList<>(runs.ofGoneHosts());
    for (RegisteredHost host : directory.all()) {
      all.addAll(
          host.reachable()
              ? runs.of(host.name())
              : runs.of(host.name(), "host " + host.name() + " is " + host.trouble()));
    }
    all.sort(
        Comparator.comparingLong((SimSummary sim) -> sim.createdAt)
            .thenComparing(sim -> sim.simId));
    total.value = all.size();
    return all.stream()
        .skip(Integer.toUnsignedLong(offset))
        .limit(Integer.toUnsignedLong(maxCount))
        .toArray(SimSummary[]::new);
  }

  /** Shows the last known state of hosts that are gone or do not answer. */
  @Override
  public SimDetail showSimulation(String simId) throws NotAuthorized, NotFound {
    Optional<SimDetail> now = queryHostOf(simId, host -> host.showSimulation(simId));
    now.ifPresent(directory.runs()::read);
    return now.or(() -> lastKnown(simId)).orElseThrow(() -> noSimulation(simId));
  }

  private Optional<SimDetail> lastKnown(String simId) {
    Optional<SimDetail> last = directory.runs().lastKnown(simId);
    last.ifPresent(
        detail ->
            directory
                .find(detail.summary.hostName)
                .filter(host -> !host.reachable())
                .ifPresent(
                    host ->
                        detail.summary =
                            RunRegistry.copy(
                                detail.summary,
                                "host "
                                    + host.name()
                                    + " is "
                                    + host.trouble()
                                    + "; last known: "
                                    + detail.summary.text)));
    return last;
  }

  /** Calls the host that has a run, or all hosts if that host is not known. */
  private <T> Optional<T> queryHostOf(String simId, HostCalls.Query<T> question)
      throws NotAuthorized {
    Optional<RegisteredHost> known = directory.runs().hostOf(simId).flatMap(directory::find);
    if (known.isEmpty()) {
      return directory.search(question);
    }
    return known.get().reachable()
        ? directory.calls().query(known.get().host(), question).value()
        : Optional.empty();
  }

  private NotFound noSimulation(String simId) {
    return ContractErrors.notFound("there is no simulation " + simId + directory.silentHosts());
  }

  @Override
  public ServiceEvent[] events(long afterSeqNo, int maxCount, int waitMillis) {
    return journal.eventsAfter(
        afterSeqNo,
        Integer.toUnsignedLong(maxCount),
        Math.min(Integer.toUnsignedLong(waitMillis), MAX_WAIT_MILLIS.value));
  }

  @Override
  public LogLine[] logs(String hostName, long since, int maxCount) throws NotFound {
    if (hostName.isEmpty()) {
      return journal.since(since, maxCount);
    }
    return query(require(hostName), host -> host.logs(since, maxCount))
        .value()
        .orElseThrow(() -> silent(hostName));
  }

  /** Does not wait for silent hosts. */
  private <T> HostCalls.Answer<T> query(RegisteredHost host, HostCalls.Query<T> question)
      throws NotFound {
    if (!host.reachable()) {
      throw silent(host.name());
    }
    return directory.calls().query(host.host(), question);
  }

  private RegisteredHost require(String hostName) throws NotFound {
    return directory
        .find(hostName)
        .orElseThrow(() -> ContractErrors.notFound("there is no host \"" + hostName + "\""));
  }

  @Override
  public void killSimulation(String simId, String reason) throws NotAuthorized, NotFound {
    Optional<Boolean> killed =
        queryHostOf(
            simId,
            host -> {
              host.killSimulation(simId, reason);
              return true;
            });
    if (killed.isEmpty()) {
      throw directory
          .runs()
          .endOf(simId)
          .map(ContractErrors::notFound)
          .orElseGet(() -> noSimulation(simId));
    }
  }

  @Override
  public SessionSummary[] listSessions() {
    directory.refresh();
    List<SessionSummary> all = new ArrayList<>();
    for (RegisteredHost host : directory.all()) {
      if (host.reachable()) {
        directory
            .calls()
            .query(host.host(), MechSimHostOperations::listSessions)
            .value()
            .ifPresent(found -> all.addAll(List.of(found)));
      }
    }
    all.sort(Comparator.comparingLong(session -> session.openedAt));
    return all.toArray(SessionSummary[]::new);
  }

  @Override
  public int endSessions(String owner, String sessionId, String reason) throws NotFound {
    int count = 0;
    for (RegisteredHost host : directory.all()) {
      if (host.reachable()) {
        count +=
            directory
                .calls()
                .query(host.host(), asked -> asked.endSessions(owner, sessionId, reason))
                .value()
                .orElse(0);
      }
    }
    if (count == 0) {
      throw ContractErrors.notFound(
          "there is no session "
              + (sessionId.isEmpty() ? "of \"" + owner + "\"" : sessionId)
              + directory.silentHosts());
    }
    return count;
  }

  @Override
  public Limit[] getLimits(String hostName) throws NotFound {
    if (hostName.isEmpty()) {
      return limits.inForce().toLimits();
    }
    return query(require(hostName), MechSimHostOperations::getLimits)
        .value()
        .orElseThrow(() -> silent(hostName));
  }

  private NotFound silent(String hostName) {
    String since =
        directory
            .find(hostName)
            .map(RegisteredHost::trouble)
            .filter(trouble -> !trouble.isEmpty())
            .map(trouble -> "; " + trouble)
            .orElse("");
    return ContractErrors.notFound("host " + hostName + " does not answer" + since);
  }

  @Override
  public void setLimits(String hostName, Limit[] values) throws NotFound, InvalidOption {
    if (hostName.isEmpty()) {
      limits.change(values);
      return;
    }
    HostCalls.Answer<Boolean> answer =
        query(
            require(hostName),
            host -> {
              host.setLimits(values);
              return true;
            });
    if (answer.refusal().isPresent() && answer.refusal().get() instanceof InvalidOption refusal) {
      throw refusal;
    } else if (answer.value().isEmpty()) {
      throw silent(hostName);
    }
  }

  @Override
  public String getPlacement() {
    return placement.policy().label();
  }

  @Override
  public void setPlacement(String policy) throws InvalidOption {
    placement.follow(
        PlacementPolicy.named(policy)
            .orElseThrow(
                () ->
                    ContractErrors.option(
                        "placement",
                        "there is no placement \""
                            + policy
                            + "\"; there are "
                            + PlacementPolicy.labels())));
    record("limit-set", "hosts are chosen by \"" + policy + "\" now");
  }

  private void record(String kind, String text) {
    journal.add(JournalEntry.info(kind, text));
  }

  @Override
  public void drain(String hostName) throws NotFound {
    setDraining(hostName, true);
  }

  @Override
  public void undrain(String hostName) throws NotFound {
    setDraining(hostName, false);
  }

  private void setDraining(String hostName, boolean drain) throws NotFound {
    if (hostName.isEmpty()) {
      server.setDraining(drain);
      record(
          drain ? "drained" : "undrained",
          drain ? "the server takes no new sessions" : "the server takes new sessions again");
      // Other hosts outlive the server and may serve others: they are emptied by their own names.
      directory.all().stream()
          .filter(RegisteredHost::own)
          .forEach(host -> setDraining(host, drain));
      return;
    }
    RegisteredHost host = require(hostName);
    if (!host.reachable() || !setDraining(host, drain)) {
      throw silent(hostName);
    }
  }

  private boolean setDraining(RegisteredHost known, boolean drain) {
    HostCalls.Answer<Boolean> answer =
        directory
            .calls()
            .query(
                known.host(),
                host -> {
                  if (drain) {
                    host.drain();
                  } else {
                    host.undrain();
                  }
                  return true;
                });
    answer.value().ifPresent(heard -> known.recordDraining(drain));
    return answer.value().isPresent();
  }

  @Override
  public void shutdownServer(int graceSeconds) {
    shutdown.within(Integer.toUnsignedLong(graceSeconds));
  }
}
