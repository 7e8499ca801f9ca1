package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.orb.PortInUseException;
import org.mechservice.orb.testing.Eventually;

@Tag("slow")
class ServerProcessTest {
  /** Threads that Java keeps for a while: the second waits for ends of further processes. */
  private static final Set<String> OF_JAVA = Set.of("Common-Cleaner", "process reaper");

  private static final int SEED = 20262;

  private static int port(Farm farm) {
    return Integer.parseInt(farm.server.url().replaceAll(".*:(\\d+)/.*", "$1"));
  }

  @Test
  void takenPortIsNamed() throws Exception {
    try (Farm farm = new Farm(1)) {
      ServerSettings same = new ServerSettings("second", "127.0.0.1", port(farm), 1);
      assertThatThrownBy(() -> MechServerProcess.start(same))
          .isInstanceOf(PortInUseException.class)
          .hasMessageContaining("127.0.0.1:" + port(farm));
    }
  }

  @Test
  void addressOfTheNetworkIsRefused() {
    assertThatThrownBy(() -> MechServerProcess.start(new ServerSettings("s", "0.0.0.0", 0, 1)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-004 cannot listen on 0.0.0.0");
  }

  @Test
  void runGoesOnWhileGarbageArrives() throws Exception {
    Random random = new Random(SEED);
    try (Farm farm = new Farm(1)) {
      IMechSimRemote run = Farm.running(farm.session(""));
      for (int i = 0; i < 100; i++) {
        byte[] garbage = new byte[random.nextInt(2000)];
        random.nextBytes(garbage);
        byte[] magic = {
          'G', 'I', 'O', 'P', 1, 2, 0, 0, 0x7F, (byte) 0xFF, (byte) 0xFF, (byte) 0xF0
        };
        send(port(farm), i % 2 == 0 ? garbage : magic);
      }
      long before = run.getProgress().stepsDone;
      Eventually.holds(() -> run.getProgress().stepsDone > before);
    }
  }

  private static void send(int port, byte[] bytes) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.getOutputStream().write(bytes);
    } catch (SocketException closedByServer) {
      assertThat(closedByServer).isNotNull();
    }
  }

  @Test
  void nothingIsLeftOfAClosedServer() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    Set<ProcessHandle> processes = children();
    try (Farm farm = new Farm(2)) {
      farm.host("h", 1);
      Farm.running(farm.session("h"));
      Farm.running(farm.session("own"));
      farm.admin.listHosts();
    }
    Eventually.holds(() -> processes.containsAll(children()));
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (!before.contains(thread) && !OF_JAVA.contains(thread.getName())) {
        thread.join(10_000);
        assertThat(thread.isAlive()).as(thread.getName()).isFalse();
      }
    }
  }

  private static Set<ProcessHandle> children() {
    return ProcessHandle.current().children().collect(Collectors.toSet());
  }

  @Test
  void closingTwiceIsClosingOnce() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.server.close();
      farm.server.close();
      farm.server.awaitShutdown();
    }
  }
}
