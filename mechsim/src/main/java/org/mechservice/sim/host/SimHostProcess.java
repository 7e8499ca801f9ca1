package org.mechservice.sim.host;

/**
 * The process behind {@code mech simhost}: opens one port, registers with a server and renews until
 * it is closed.
 */
public final class SimHostProcess implements AutoCloseable {
  private SimHostProcess() {}

  /**
   * Starts a host and registers it.
   *
   * @throws org.mechservice.orb.ServiceUnreachableException if the server cannot be reached
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   */
  public static SimHostProcess start(HostSettings settings) {
    throw new UnsupportedOperationException();
  }

  /** Returns {@code host:port} its MechSims are reached at. */
  public String address() {
    throw new UnsupportedOperationException();
  }

  /** Waits until the process is closed. */
  public void awaitShutdown() throws InterruptedException {
    throw new UnsupportedOperationException();
  }

  @Override
  public void close() {
    throw new UnsupportedOperationException();
  }
}
