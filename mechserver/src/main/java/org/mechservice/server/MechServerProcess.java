package org.mechservice.server;

/** The process behind {@code mech server}, and the embedded server of the command line. */
public final class MechServerProcess implements AutoCloseable {
  private MechServerProcess() {}

  /**
   * Starts a server.
   *
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   */
  public static MechServerProcess start(ServerSettings settings) {
    throw new UnsupportedOperationException();
  }

  /** Returns the URL clients connect to, {@code corbaloc:iiop:1.2@host:port/MechServer}. */
  public String url() {
    throw new UnsupportedOperationException();
  }

  /** Waits until the server is shut down. */
  public void awaitShutdown() throws InterruptedException {
    throw new UnsupportedOperationException();
  }

  @Override
  public void close() {
    throw new UnsupportedOperationException();
  }
}
