package org.mechservice.server;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimSummary;
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
  private final ServerTuning tuning;
  private final Journal journal;
  private final Shutdown shutdown;

  MechAdminServant(
      MechServerServant server,
      HostDirectory directory,
      ServerTuning tuning,
      Journal journal,
      Shutdown shutdown) {
    this.server = server;
    this.directory = directory;
    this.tuning = tuning;
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
  public SimDetail showSimulation(String simId) throws NotAvailable {
    throw Refusal.notAvailable(
        "details of a simulation are not in this version; listSimulations shows its progress");
  }

  @Override
  public SimEvent[] events(long afterSeqNo, int maxCount) throws NotAvailable {
    throw Refusal.notAvailable("events of all sessions are not in this version; ask for the logs");
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
        .orElseThrow(() -> Refusal.notFound("host " + hostName + " does not answer"));
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
      throw Refusal.notFound("there is no simulation " + simId + " on a host that answers");
    }
    journal.info("simulation " + simId + " cancelled by the operator: " + reason);
  }

  @Override
  public Limit[] getLimits(String hostName) throws NotFound {
    if (!hostName.isEmpty()) {
      require(hostName);
    }
    return tuning.limits().toLimits();
  }

  @Override
  public void setLimits(String hostName, Limit[] values) throws NotAvailable {
    throw Refusal.notAvailable("changing limits is not in this version");
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
      journal.info(drain ? "takes no new sessions" : "takes new sessions again");
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
      throw Refusal.notFound("host " + hostName + " does not answer");
    }
  }

  @Override
  public void shutdownServer(int graceSeconds) {
    shutdown.within(Integer.toUnsignedLong(graceSeconds));
  }
}
