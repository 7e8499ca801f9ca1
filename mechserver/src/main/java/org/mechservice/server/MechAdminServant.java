package org.mechservice.server;

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
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimSummary;
import org.mechservice.sim.service.Happening;
import org.mechservice.sim.service.Journal;
import org.mechservice.sim.service.Refusal;
import org.omg.CORBA.IntHolder;

/** What administrators ask. Every answer comes in time: silent hosts are left out of it. */
final class MechAdminServant implements MechAdminOperations {
  /** Ends the server. */
  interface Shutdown {
    void within(long graceSeconds);
  }

  private final MechServerServant server;
  private final HostDirectory directory;
  private final Placement placement;
  private final FarmLimits limits;
  private final Journal journal;
  private final Shutdown shutdown;

  MechAdminServant(
      MechServerServant server,
      HostDirectory directory,
      Placement placement,
      FarmLimits limits,
      Journal journal,
      Shutdown shutdown) {
    this.server = server;
    this.directory = directory;
    this.placement = placement;
    this.limits = limits;
    this.journal = journal;
    this.shutdown = shutdown;
  }

  @Override
  public ServerStatus getStatus() {
    List<HostLoad> loads = directory.refresh().stream().map(KnownHost::load).toList();
    Runtime machine = Runtime.getRuntime();
    return new ServerStatus(
        server.getInfo(),
        server.draining(),
        directory.all().size(),
        loads.stream().mapToInt(load -> load.sessions).sum(),
        loads.stream().mapToInt(load -> load.running).sum(),
        loads.stream().mapToInt(load -> load.queued).sum(),
        new NameValue[] {
          new NameValue(
              "uptimeSeconds",
              Long.toString((System.currentTimeMillis() - server.getInfo().startedAt) / 1000)),
          new NameValue("heapBytes", Long.toString(machine.totalMemory() - machine.freeMemory()))
        });
  }

  @Override
  public HostStatus[] listHosts() {
    directory.refresh();
    return directory.statuses().toArray(HostStatus[]::new);
  }

  @Override
  public SimSummary[] listSimulations(int offset, int maxCount, IntHolder total) {
    List<SimSummary> all = new ArrayList<>();
    directory
        .askAll(MechSimHostOperations::listSimulations)
        .values()
        .forEach(ofHost -> all.addAll(List.of(ofHost)));
    all.addAll(directory.lostRuns().summaries());
    all.sort(
        Comparator.comparingLong((SimSummary sim) -> sim.createdAt)
            .thenComparing(sim -> sim.simId));
    total.value = all.size();
    return all.stream()
        .skip(Integer.toUnsignedLong(offset))
        .limit(Integer.toUnsignedLong(maxCount))
        .toArray(SimSummary[]::new);
  }

  @Override
  public SimDetail showSimulation(String simId) throws NotFound {
    return directory.askAll(host -> host.showSimulation(simId)).values().stream()
        .findFirst()
        .orElseThrow(() -> noSimulation(simId));
  }

  private static NotFound noSimulation(String simId) {
    return Refusal.notFound("there is no simulation " + simId + " on a host that answers");
  }

  @Override
  public ServiceEvent[] events(long afterSeqNo, int maxCount, int waitMillis) {
    return journal
        .events()
        .after(
            afterSeqNo,
            Integer.toUnsignedLong(maxCount),
            Math.min(Integer.toUnsignedLong(waitMillis), MAX_WAIT_MILLIS.value));
  }

  @Override
  public LogLine[] logs(String hostName, long since, int maxCount) throws NotFound {
    if (hostName.isEmpty()) {
      return journal.since(since, maxCount);
    }
    return directory
        .calls()
        .ask(require(hostName).host(), host -> host.logs(since, maxCount))
        .value()
        .orElseThrow(() -> silent(hostName));
  }

  private KnownHost require(String hostName) throws NotFound {
    return directory
        .find(hostName)
        .orElseThrow(() -> Refusal.notFound("there is no host \"" + hostName + "\""));
  }

  @Override
  public void killSimulation(String simId, String reason) throws NotFound {
    Optional<Boolean> killed =
        directory
            .askAll(
                host -> {
                  host.killSimulation(simId, reason);
                  return true;
                })
            .values()
            .stream()
            .findFirst();
    if (killed.isEmpty()) {
      throw noSimulation(simId);
    }
  }

  @Override
  public Limit[] getLimits(String hostName) throws NotFound {
    if (hostName.isEmpty()) {
      return limits.inForce().toLimits();
    }
    return directory
        .calls()
        .ask(require(hostName).host(), MechSimHostOperations::getLimits)
        .value()
        .orElseThrow(() -> silent(hostName));
  }

  private static NotFound silent(String hostName) {
    return Refusal.notFound("host " + hostName + " does not answer");
  }

  @Override
  public void setLimits(String hostName, Limit[] values) throws NotFound, InvalidOption {
    if (hostName.isEmpty()) {
      limits.change(values);
      return;
    }
    HostCalls.Answer<Boolean> answer =
        directory
            .calls()
            .ask(
                require(hostName).host(),
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
                    Refusal.option(
                        "placement",
                        "there is no placement \""
                            + policy
                            + "\"; there are "
                            + PlacementPolicy.labels())));
    tell("limit-set", "hosts are chosen by \"" + policy + "\" now");
  }

  private void tell(String kind, String text) {
    journal.tell(Happening.info(kind, text));
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
      tell(
          drain ? "drained" : "undrained",
          drain ? "the server takes no new sessions" : "the server takes new sessions again");
      return;
    }
    boolean done =
        directory
            .calls()
            .ask(
                require(hostName).host(),
                host -> {
                  if (drain) {
                    host.drain();
                  } else {
                    host.undrain();
                  }
                  return true;
                })
            .value()
            .isPresent();
    if (!done) {
      throw silent(hostName);
    }
  }

  @Override
  public void shutdownServer(int graceSeconds) {
    shutdown.within(Integer.toUnsignedLong(graceSeconds));
  }
}
