package org.mechservice.server;

import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;

/** A host in a process of its own: prints its address, runs until it is killed. */
final class HostMain {
  private HostMain() {}

  @SuppressWarnings("SystemOut") // how the test learns that the host is registered
  public static void main(String[] arguments) throws InterruptedException {
    try (SimHostProcess host =
        SimHostProcess.start(new HostSettings(arguments[0], arguments[1], "127.0.0.1", 0, 1))) {
      System.out.println(host.address());
      host.awaitShutdown();
    }
  }
}
