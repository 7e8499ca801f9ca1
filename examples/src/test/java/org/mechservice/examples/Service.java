package org.mechservice.examples;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.function.BooleanSupplier;

/** Processes of the service on this machine, started with {@code ./mech}. */
final class Service {
  private Service() {}

  /** Returns a loopback port that was free a moment ago. */
  static int freePort() {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    } catch (IOException e) {
      throw new AssertionError("no free port", e);
    }
  }

  /** Returns the address clients use for a server on this machine. */
  static String url(int port) {
    return "corbaloc:iiop:1.2@127.0.0.1:" + port + "/MechServer";
  }

  /** Starts {@code ./mech server} and waits until it listens. */
  static Terminal.Running startServer(Path directory, int port) {
    Terminal.Running server =
        new Terminal(directory).startMech("server", "--port", Integer.toString(port));
    return ready(server, "server on port " + port, () -> isListening(port));
  }

  /** Starts {@code ./mech simhost} and waits until the server lists it. */
  static Terminal.Running startHost(Path directory, int serverPort, String name) {
    Terminal terminal = new Terminal(directory);
    Terminal.Running host =
        terminal.startMech(
            "simhost",
            "--server",
            url(serverPort),
            "--listen",
            "127.0.0.1:" + freePort(),
            "--name",
            name);
    return ready(host, "host " + name, () -> status(terminal, serverPort).contains(name));
  }

  /** Returns what {@code mech admin status} prints. */
  static String status(Terminal terminal, int serverPort) {
    return terminal.mech("admin", "--server", url(serverPort), "status").orFail().stdout();
  }

  private static Terminal.Running ready(
      Terminal.Running process, String what, BooleanSupplier condition) {
    try {
      process.awaitThat(what, condition);
      return process;
    } catch (AssertionError e) {
      process.close();
      throw e;
    }
  }

  private static boolean isListening(int port) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 1000);
      return true;
    } catch (IOException e) {
      return false;
    }
  }
}
