package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.JarCache;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.MechAdmin;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.tls.TlsIdentity;

/**
 * A server and two hosts, each on a network of its own; the cable to one host is cut. The server
 * notices, says so, and goes on with the other; when the cable is mended, the host is back.
 *
 * <p>Hosts on other addresses need TLS, so all of them use it. Where namespaces are to be had (root
 * on Linux), each host has one, joined to the server's by a pair of virtual cards; elsewhere hosts
 * have loopback addresses of their own behind a relay that is cut instead, which is said on
 * standard error.
 */
@Tag("slow")
class CutOffHostTest {
  private static final long PATIENCE_SECONDS = 90;

  @TempDir Path folder;

  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private boolean namespaces;
  private String tag = "";

  private static int run(String... command) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    if (!process.waitFor(60, TimeUnit.SECONDS)) {
      process.destroyForcibly();
    }
    return process.waitFor();
  }

  /** Joins a new network to this one by a cable; its ends are 10.77.NET.1 here and .2 there. */
  private boolean network(int number) throws IOException, InterruptedException {
    String name = "mech" + tag + number;
    String here = "mv" + tag + number;
    String there = "mw" + tag + number;
    String address = "10.77." + number + ".";
    List<String[]> commands = new ArrayList<>();
    commands.add(new String[] {"ip", "netns", "add", name});
    commands.add(new String[] {"ip", "link", "add", here, "type", "veth", "peer", "name", there});
    commands.add(new String[] {"ip", "link", "set", there, "netns", name});
    commands.add(new String[] {"ip", "addr", "add", address + "1/24", "dev", here});
    commands.add(new String[] {"ip", "link", "set", here, "up"});
    String[] inside = {"ip", "-n", name};
    commands.add(joined(inside, "addr", "add", address + "2/24", "dev", there));
    commands.add(joined(inside, "link", "set", there, "up"));
    commands.add(joined(inside, "link", "set", "lo", "up"));
    commands.add(joined(inside, "route", "add", "default", "via", address + "1"));
    parts.push(() -> run("ip", "netns", "del", name));
    parts.push(() -> run("ip", "link", "del", here));
    for (String[] command : commands) {
      if (run(command) != 0) {
        return false;
      }
    }
    return true;
  }

  private static String[] joined(String[] first, String... more) {
    List<String> all = new ArrayList<>(List.of(first));
    all.addAll(List.of(more));
    return all.toArray(String[]::new);
  }

  @BeforeEach
  void connectNetworks() throws Exception {
    tag = Long.toString(ProcessHandle.current().pid() % 1000) + "x";
    try {
      namespaces = network(1) && network(2);
    } catch (IOException e) {
      namespaces = false; // there is no such command
    }
    if (!namespaces) {
      System.err.println(
          "no network namespaces here: hosts are on loopback addresses, behind relays");
    }
  }

  @AfterEach
  void end() throws Exception {
    while (!parts.isEmpty()) {
      parts.pop().close();
    }
  }

  /** A host, and what cuts and mends its cable. */
  private record Far(String name, Cable cut, Cable mend) {}

  private interface Cable {
    void handle() throws Exception;
  }

  private static int freePort(String address) throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(address))) {
      return socket.getLocalPort();
    }
  }

  private ServiceJvm part(ServiceJvm jvm) {
    parts.push(jvm);
    return jvm;
  }

  private Far host(int number, String server) throws Exception {
    String name = "far" + number;
    String keys = folder.resolve("keys").resolve(name).toString();
    if (namespaces) {
      String address = "10.77." + number + ".2:15001";
      part(
          ServiceJvm.start(
              List.of("ip", "netns", "exec", "mech" + tag + number),
              128,
              words(server, address, name, keys)));
      String card = "mv" + tag + number;
      return new Far(
          name,
          () -> assertThat(run("ip", "link", "set", card, "down")).isZero(),
          () -> assertThat(run("ip", "link", "set", card, "up")).isZero());
    }
    // The host says it is where the relay is: at the same port of another loopback address.
    int port = freePort("127.0.0." + (10 + number));
    Relay relay =
        new Relay(
            new InetSocketAddress(InetAddress.getByName("127.0.0." + (20 + number)), port),
            new InetSocketAddress(InetAddress.getByName("127.0.0." + (10 + number)), port),
            0);
    parts.push(relay);
    part(
        ServiceJvm.start(
            List.of(),
            128,
            List.of(
                "-Djacorb.ior_proxy_host=127.0.0." + (20 + number),
                "-Djacorb.ior_proxy_port=" + port),
            words(server, "127.0.0." + (10 + number) + ":" + port, name, keys)));
    return new Far(name, relay::cut, relay::mend);
  }

  private static String[] words(String server, String address, String name, String keys) {
    return new String[] {
      "simhost", "--server", server, "--listen", address, "--name", name, "--tls", keys
    };
  }

  @Test
  void hostThatIsCutOffIsGivenUpAndComesBack() throws Exception {
    makeKeys();
    String address = namespaces ? "10.77.2.1" : "127.0.0.1"; // of the cable that is not cut
    ServiceJvm server =
        part(
            ServiceJvm.start(
                List.of(),
                128,
                "server",
                "--listen",
                address + ":" + freePort(address),
                "--capacity",
                "0",
                "--tls",
                folder.resolve("keys/server").toString()));
    String url = address + ":" + server.port();
    Far first = host(1, url);
    Far second = host(2, url);
    try (ServiceOrb operator = ServiceOrb.client(Optional.of(identity("root")));
        MechConnection client =
            MechConnection.open(url, new JarCache(folder), Optional.of(identity("ann")))) {
      MechAdmin admin = operator.connectAdmin(url);
      List<Long> alone = simulated(client, first.name());
      assertThat(simulated(client, second.name())).isEqualTo(alone);
      first.cut().handle();
      awaitReachable(admin, first.name(), false);
      assertThat(simulated(client, "")).isEqualTo(alone);
      first.mend().handle();
      awaitReachable(admin, first.name(), true);
      assertThat(simulated(client, first.name())).isEqualTo(alone);
    }
  }

  private TlsIdentity identity(String name) {
    return TlsIdentity.load(folder.resolve("keys").resolve(name));
  }

  private void makeKeys() {
    PrintWriter nowhere = new PrintWriter(new StringWriter());
    String[] words = {
      "keys",
      folder.resolve("keys").toString(),
      "--host",
      "server,10.77.2.1,127.0.0.1",
      "--host",
      "far1,10.77.1.2,127.0.0.11,127.0.0.21",
      "--host",
      "far2,10.77.2.2,127.0.0.12,127.0.0.22",
      "--client",
      "ann",
      "--admin",
      "root"
    };
    assertThat(Mech.run(nowhere, nowhere, words)).isZero();
  }

  private static List<Long> simulated(MechConnection client, String host) throws IOException {
    try (MechSession session = client.openSession(host)) {
      session.loadModel(Runs.PENDULUM);
      return Runs.bits(session, SimulationOptions.asInFile(), false);
    }
  }

  private static void awaitReachable(MechAdmin admin, String host, boolean wanted)
      throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    while (reachable(admin, host) != wanted) {
      assertThat(System.nanoTime()).as(host + " reachable: " + wanted).isLessThan(end);
      Thread.sleep(200);
    }
  }

  private static boolean reachable(MechAdmin admin, String host) throws Exception {
    for (HostStatus status : admin.listHosts()) {
      if (status.info.name.equals(host) && status.reachable) {
        return true;
      }
    }
    return false;
  }
}
