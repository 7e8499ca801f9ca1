package org.mechservice.examples;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;

/** Processes of the service on this machine, started with {@code ./mech}. */
final class Service {
  private Service() {}

  /** Returns a loopback port that was free a moment ago, none of those given to connections. */
  static int freePort() {
    while (true) {
      int port = ThreadLocalRandom.current().nextInt(20_000, 30_000);
      try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
        return socket.getLocalPort();
      } catch (BindException e) {
        // Somebody has it: another one.
      } catch (IOException e) {
        throw new AssertionError("no free port", e);
      }
    }
  }

  /** Returns the address clients use for a server on this machine. */
  static String url(int port) {
    return "corbaloc:iiop:1.2@127.0.0.1:" + port + "/MechServer";
  }

  /** Starts {@code ./mech server} and waits until it prints its URL. */
  static Terminal.Running startServer(Path directory, int port, String... options) {
    List<String> words = new ArrayList<>(List.of("server", "--port", Integer.toString(port)));
    words.addAll(List.of(options));
    return ready(new Terminal(directory).startMech(words.toArray(String[]::new)), url(port));
  }

  /** Starts {@code ./mech simhost} and waits until it has registered and prints its address. */
  static Terminal.Running startHost(Path directory, int serverPort, String name) {
    String address = "127.0.0.1:" + freePort();
    return ready(
        new Terminal(directory)
            .startMech("simhost", "--server", url(serverPort), "--listen", address, "--name", name),
        address);
  }

  /** Returns what {@code mech admin status} prints. */
  static String status(Terminal terminal, int serverPort) {
    return terminal.mech("admin", "--server", url(serverPort), "status").orFail().stdout();
  }

  private static Terminal.Running ready(Terminal.Running process, String printed) {
    try {
      process.awaitThat(printed, () -> process.stdout().contains(printed));
      return process;
    } catch (AssertionError e) {
      process.close();
      throw e;
    }
  }
}
