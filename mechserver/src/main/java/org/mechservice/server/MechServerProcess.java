package org.mechservice.server;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.mechservice.idl.HostRegistryOperations;
import org.mechservice.idl.HostRegistryPOATie;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.MechAdminPOATie;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.MechServerPOATie;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceKey;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.server.admin.AuditLog;
import org.mechservice.server.admin.MechAdminServant;
import org.mechservice.server.admin.Metrics;
import org.mechservice.server.admin.MetricsEndpoint;
import org.mechservice.server.hosts.FarmLimits;
import org.mechservice.server.hosts.HostDirectory;
import org.mechservice.server.hosts.HostRegistryServant;
import org.mechservice.server.hosts.MechServerServant;
import org.mechservice.server.hosts.Placement;
import org.mechservice.server.hosts.RegisteredHost;
import org.mechservice.server.hosts.ServerTuning;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.contract.AccessRights;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.sim.service.limits.CurrentLimits;

/** The process behind {@code mech server}, and the embedded server of the command line. */
public final class MechServerProcess implements AutoCloseable {
  private static final long CLOSING_MILLIS = 5000;

  private final ServiceOrb orb;
  private final HostDirectory directory;
  private final Optional<SimHost> ownHost;
  private final MechServerServant server;
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicBoolean closing = new AtomicBoolean();
  private final ServerPublication findable;
  private final Optional<AuditLog> audit;
  private final Optional<MetricsEndpoint> metrics;

  private MechServerProcess(
      ServerSettings settings, ServiceOrb orb, ServerTuning tuning, HostFactory host) {
    this.orb = orb;
    audit = settings.auditFile().map(AuditLog::open);
    Journal journal = new Journal("server", event -> audit.ifPresent(log -> log.write(event)));
    directory = new HostDirectory(tuning, orb.outbound(), journal);
    CurrentLimits limits = new CurrentLimits(settings.host().limits());
    orb.allowConnections(limits.now().connectionsAtAll());
    Placement placement = new Placement(directory, settings.placement());
    server = new MechServerServant(settings.name(), directory, placement, limits);
    ownHost =
        settings.host().capacity() > 0
            ? Optional.of(host.open(orb, settings, limits, this::close))
            : Optional.empty();
    ownHost.ifPresent(
        own ->
            directory.add(
                new RegisteredHost(
                    own.getInfo(),
                    GuardedServant.of(MechSimHostOperations.class, own, () -> {}),
                    true,
                    orb.endpoint())));
    FarmLimits farmLimits = new FarmLimits(limits, directory);
    DenialLog denials = new DenialLog(journal);
    publish(
        new MechAdminServant(
            server, directory, placement, farmLimits, journal, orb.identity(), this::shutDown),
        new HostRegistryServant(orb, directory, farmLimits, denials),
        denials);
    Metrics figures = new Metrics(directory, server, orb.identity(), audit);
    metrics =
        settings
            .metrics()
            .map(address -> MetricsEndpoint.open(address, figures::text, figures::health));
    findable = ServerPublication.make(orb, settings.iorFile(), settings.naming());
    journal.add(JournalEntry.info("server-started", "server " + settings.name() + " has started"));
  }

  private void publish(MechAdminServant admin, HostRegistryServant registry, DenialLog denials) {
    orb.publish(
        Map.of(
            ServiceKey.SERVER,
            new MechServerPOATie(
                GuardedServant.of(
                    MechServerOperations.class, server, AccessRights.toSimulate(denials))),
            ServiceKey.REGISTRY,
            new HostRegistryPOATie(
                GuardedServant.of(
                    HostRegistryOperations.class, registry, AccessRights.toServe(denials))),
            ServiceKey.ADMIN,
            new MechAdminPOATie(
                GuardedServant.of(
                    MechAdminOperations.class, admin, AccessRights.toAdministrate(denials)))));
  }

  /**
   * Starts a server.
   *
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   * @throws IllegalArgumentException if the address cannot be listened on (S-004) or the reference
   *     cannot be written (S-162)
   * @throws org.mechservice.orb.ServiceUnreachableException with code S-020 if the naming service
   *     does not take the name
   */
  public static MechServerProcess start(ServerSettings settings) {
    return start(settings, ServerTuning.DEFAULT, HostFactory.INSTALLED);
  }

  static MechServerProcess start(ServerSettings settings, ServerTuning tuning, HostFactory host) {
    ServiceOrb orb =
        ServiceOrb.server(
            new ListenAddress(settings.listenAddress(), settings.port(), settings.tls()));
    try {
      return new MechServerProcess(settings, orb, tuning, host);
    } catch (RuntimeException e) {
      orb.close();
      throw e;
    }
  }

  /** Returns the URL clients connect to, {@code corbaloc:iiop:1.2@host:port/MechServer}. */
  public String url() {
    return orb.url(ServiceKey.SERVER);
  }

  /** Begins to make the server ready for its first client, if it runs simulations itself. */
  public void warmUp() {
    ownHost.ifPresent(SimHost::warmUp);
  }

  /** Returns where figures are to be had, if anywhere. */
  Optional<Integer> metricsPort() {
    return metrics.map(MetricsEndpoint::port);
  }

  private void shutDown(long graceSeconds) {
    server.setDraining(true);
    ownHost.ifPresent(SimHost::drain);
    Thread thread = new Thread(() -> stop(graceSeconds), "mechserver-shutdown");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * Accepts no new sessions, waits until no run of this process is active or the time is over, and
   * closes.
   *
   * @param graceSeconds longest wait for the runs, s
   */
  public void stop(long graceSeconds) {
    server.setDraining(true);
    ownHost.ifPresent(SimHost::drain);
    ownHost.ifPresent(host -> host.awaitIdle(graceSeconds));
    close();
  }

  /** Waits until the server is shut down. */
  public void awaitShutdown() throws InterruptedException {
    closed.await();
  }

  /** Ends all sessions of this process and closes the port. Idempotent. */
  @Override
  public void close() {
    if (closing.compareAndSet(false, true)) {
      findable.close();
      metrics.ifPresent(MetricsEndpoint::close);
      ownHost.ifPresent(SimHost::close);
      server.close();
      directory.close();
      orb.close();
      try {
        directory.calls().awaitEnd(CLOSING_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      audit.ifPresent(AuditLog::close);
      closed.countDown();
    }
  }
}
