package org.mechservice.sim.host;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.MechSimHostPOATie;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.service.HostLimits;
import org.mechservice.solver.api.Solver;

/**
 * The process behind {@code mech simhost}: opens one port, registers with a server and renews until
 * it is closed.
 */
public final class SimHostProcess implements AutoCloseable {
  private final ServiceOrb orb;
  private final SimHost host;
  private final ServerRegistration registration;
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicBoolean closing = new AtomicBoolean();

  private SimHostProcess(HostSettings settings, ServiceOrb orb, HostLimits limits, Solver solver) {
    this.orb = orb;
    host = new SimHost(orb, settings.name(), settings.capacity(), limits, solver, this::close);
    try {
      MechSimHost reference =
          MechSimHostHelper.unchecked_narrow(
              orb.activate(
                      new MechSimHostPOATie(
                          GuardedServant.of(MechSimHostOperations.class, host, () -> {})))
                  .reference());
      registration = new ServerRegistration(orb, settings.serverUrl(), host, reference);
    } catch (RuntimeException e) {
      host.close();
      throw e;
    }
  }

  /**
   * Starts a host and registers it.
   *
   * @throws org.mechservice.orb.ServiceUnreachableException if the server cannot be reached
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   * @throws IllegalArgumentException if the address cannot be listened on (S-004), the server's is
   *     none (S-006), or the server does not take the host (S-013); the message says why
   */
  public static SimHostProcess start(HostSettings settings) {
    return start(settings, HostLimits.DEFAULT, SimHost.installedSolver());
  }

  /** Starts a host with limits and a solver of one's own. */
  public static SimHostProcess start(HostSettings settings, HostLimits limits, Solver solver) {
    ServiceOrb orb = ServiceOrb.host(new ListenAddress(settings.listenAddress(), settings.port()));
    try {
      return new SimHostProcess(settings, orb, limits, solver);
    } catch (RuntimeException e) {
      orb.close();
      throw e;
    }
  }

  /** Returns {@code host:port} its MechSims are reached at. */
  public String address() {
    return orb.endpoint().toString();
  }

  /** Waits until the process is closed. */
  public void awaitShutdown() throws InterruptedException {
    closed.await();
  }

  /** Signs off at the server, ends all sessions and closes the port. Idempotent. */
  @Override
  public void close() {
    if (closing.compareAndSet(false, true)) {
      registration.close();
      host.close();
      orb.close();
      closed.countDown();
    }
  }
}
