package org.mechservice.sim.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostPOATie;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.solver.api.Solver;

/**
 * The process behind {@code mech simhost}: opens one port, registers with its servers and renews
 * until it is closed.
 */
public final class SimHostProcess implements AutoCloseable {
  private final ServiceOrb orb;
  private final SimHost host;
  private final MechSimHost reference;
  private final List<ServerRegistration> registrations = new ArrayList<>();
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicBoolean closing = new AtomicBoolean();

  private SimHostProcess(HostSettings settings, ServiceOrb orb, Solver solver) {
    this.orb = orb;
    host = new SimHost(orb, settings.host(), solver, this::close);
    try {
      reference =
          MechSimHostHelper.unchecked_narrow(
              orb.activate(new MechSimHostPOATie(host.forServers())).reference());
      register(settings.serverUrls());
    } catch (RuntimeException e) {
      registrations.forEach(ServerRegistration::close);
      host.close();
      throw e;
    }
  }

  /** One server must be there; the others are tried again until they are. */
  private void register(List<String> serverUrls) {
    Optional<ServiceUnreachableException> unreachable = Optional.empty();
    boolean registered = false;
    for (String url : serverUrls) {
      ServerRegistration registration = new ServerRegistration(orb, url, host, reference);
      registrations.add(registration);
      try {
        registration.begin();
        registered = true;
      } catch (ServiceUnreachableException e) {
        unreachable = Optional.of(unreachable.orElse(e));
        registration.keepTrying();
      }
    }
    if (!registered && unreachable.isPresent()) {
      throw unreachable.get();
    }
  }

  /**
   * Starts a host and registers it.
   *
   * @throws org.mechservice.orb.ServiceUnreachableException if none of the servers can be reached
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   * @throws IllegalArgumentException if the address cannot be listened on (S-004), a server's is
   *     none (S-006), a server does not take the host (S-013), or the spool folder cannot be used
   *     (S-114); the message says why
   */
  public static SimHostProcess start(HostSettings settings) {
    return start(settings, SimHost.installedSolver());
  }

  /** Starts a host with a solver of one's own. */
  public static SimHostProcess start(HostSettings settings, Solver solver) {
    ServiceOrb orb =
        ServiceOrb.host(
            new ListenAddress(settings.listenAddress(), settings.port(), settings.tls()));
    try {
      return new SimHostProcess(settings, orb, solver);
    } catch (RuntimeException e) {
      orb.close();
      throw e;
    }
  }

  /** Returns {@code host:port} its MechSims are reached at. */
  public String address() {
    return orb.endpoint().toString();
  }

  /** Returns the reference that servers call. */
  public MechSimHost reference() {
    return reference;
  }

  /** Begins to load classes for the first client. */
  public void warmUp() {
    host.warmUp();
  }

  /**
   * Accepts no new sessions, waits until no run is active, because all have moved to other hosts or
   * ended, or the time is over, and closes.
   *
   * @param graceSeconds longest wait for the runs, s
   */
  public void stop(long graceSeconds) {
    host.drain();
    host.awaitIdle(graceSeconds);
    close();
  }

  /** Waits until the process is closed. */
  public void awaitShutdown() throws InterruptedException {
    closed.await();
  }

  /** Signs off at the servers, ends all sessions and closes the port. Idempotent. */
  @Override
  public void close() {
    if (closing.compareAndSet(false, true)) {
      registrations.forEach(ServerRegistration::close);
      host.close();
      orb.close();
      closed.countDown();
    }
  }
}
