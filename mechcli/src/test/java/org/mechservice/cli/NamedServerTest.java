package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.orb.testing.Eventually;

/** {@code mech server --naming} with a naming service in a process of its own. */
@Tag("slow")
class NamedServerTest {
  private static final String MODEL = "../examples/pendulum/pendulum.xml";

  @TempDir private Path folder;
  private final StringWriter err = new StringWriter();
  private final Deque<Process> processes = new ArrayDeque<>();

  private int simulate(Path file, String... more) {
    err.getBuffer().setLength(0);
    List<String> words = new ArrayList<>(List.of("simulate", MODEL, "--quiet"));
    words.addAll(List.of("--out", file.toString()));
    words.addAll(Arrays.asList(more));
    return Mech.run(
        new PrintWriter(new StringWriter()), new PrintWriter(err), words.toArray(String[]::new));
  }

  private Process java(String... words) throws IOException {
    List<String> line =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path")));
    line.addAll(Arrays.asList(words));
    Process process =
        new ProcessBuilder(line).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    processes.push(process);
    return process;
  }

  @AfterEach
  void end() throws InterruptedException {
    while (!processes.isEmpty()) {
      processes.pop().destroyForcibly().waitFor();
    }
  }

  private int namingService() throws Exception {
    int port;
    try (ServerSocket closedAtOnce = new ServerSocket(0)) {
      port = closedAtOnce.getLocalPort();
    }
    Process naming =
        java(
            "-Djacorb.naming.db_dir=" + folder,
            "-Djacorb.log.default.verbosity=0",
            "-DOAIAddr=127.0.0.1",
            "-DOAPort=" + port,
            "org.jacorb.naming.NameServer");
    Eventually.holds(
        () -> {
          assertThat(naming.isAlive()).isTrue();
          try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            return socket.isConnected();
          } catch (IOException notYet) {
            return false;
          }
        });
    return port;
  }

  private Process server(int naming) throws IOException {
    Process server =
        java(
            Mech.class.getName(),
            "server",
            "--port",
            "0",
            "--naming",
            "127.0.0.1:" + naming,
            "--capacity",
            "1");
    try (BufferedReader said = server.inputReader()) {
      assertThat(said.readLine()).startsWith("corbaloc:");
    }
    return server;
  }

  @Test
  void clientsFindAServerByItsNameUntilItEndsAndAgainWhenItIsBack() throws Exception {
    int naming = namingService();
    String url = "corbaname:iiop:1.2@127.0.0.1:" + naming + "#MechServer";
    Path plain = folder.resolve("plain.csv");
    assertThat(simulate(plain)).as(err.toString()).isZero();

    Process first = server(naming);
    Path named = folder.resolve("named.csv");
    assertThat(simulate(named, "--server", url)).as(err.toString()).isZero();
    assertThat(named).hasSameBinaryContentAs(plain);
    Process host =
        java(
            Mech.class.getName(),
            "simhost",
            "--server",
            url,
            "--listen",
            "127.0.0.1:0",
            "--name",
            "helper");
    try (BufferedReader said = host.inputReader()) {
      assertThat(said.readLine()).startsWith("127.0.0.1:");
    }
    Path there = folder.resolve("there.csv");
    assertThat(simulate(there, "--server", url, "--host", "helper")).as(err.toString()).isZero();
    assertThat(there).hasSameBinaryContentAs(plain);

    first.destroy();
    first.waitFor();
    assertThat(simulate(folder.resolve("gone.csv"), "--server", url)).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).startsWith("S-020 ").contains("knows no \"MechServer\"");

    Process second = server(naming);
    assertThat(simulate(folder.resolve("back.csv"), "--server", url)).as(err.toString()).isZero();
    assertThat(second.isAlive()).isTrue();
  }
}
