package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Servers known to a naming service of its own process, and by the file of their reference. */
class NamingServiceTest {
  private static final int PATIENCE = 300;

  @TempDir private Path folder;

  private Process startNamingService(int port) throws Exception {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                "-Djacorb.naming.db_dir=" + folder,
                "-Djacorb.log.default.verbosity=0",
                "-DOAIAddr=127.0.0.1",
                "-DOAPort=" + port,
                "org.jacorb.naming.NameServer")
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    for (int i = 0; i < PATIENCE && !listens(port); i++) {
      Thread.sleep(100);
    }
    return process;
  }

  private static boolean listens(int port) {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      return socket.isConnected();
    } catch (IOException notYet) {
      return false;
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket closedAtOnce = new ServerSocket(0)) {
      return closedAtOnce.getLocalPort();
    }
  }

  @Test
  void serverIsFoundByItsNameUntilItGivesItUp() throws Exception {
    int port = freePort();
    Process naming = startNamingService(port);
    String url = "corbaname:iiop:1.2@127.0.0.1:" + port + "#MechServer";
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect(url))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-020 the naming service at 127.0.0.1:" + port)
          .hasMessageContaining("knows no \"MechServer\"");
      Runnable unbind = server.bind("127.0.0.1:" + port);
      assertThat(client.connect(url).getInfo().serverName).isEqualTo("echo €");
      try (ServiceOrb host = ServiceOrb.host(new ListenAddress("127.0.0.1", 0))) {
        // A host may only connect to its server, and to the naming service that knows it.
        assertThat(host.connect(url).getInfo().serverName).isEqualTo("echo €");
      }
      unbind.run();
      assertThatThrownBy(() -> client.connect(url)).hasMessageContaining("S-020");
    } finally {
      naming.destroyForcibly().waitFor();
    }
  }

  @Test
  void namingServiceThatIsNotThereIsSaid() throws Exception {
    String nobody = "127.0.0.1:" + freePort();
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect("corbaname::" + nobody + "#MechServer"))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageContaining("S-020 the naming service at " + nobody + ": it does not answer");
      assertThatThrownBy(() -> server.bind(nobody))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageContaining("S-020");
    }
  }

  @Test
  void serverIsFoundByTheFileOfItsReference() throws IOException {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      Path file = folder.resolve("server.ior");
      Files.writeString(file, server.ior() + "\n");
      assertThat(client.connect(file.toString()).getInfo().serverName).isEqualTo("echo €");
    }
  }
}
