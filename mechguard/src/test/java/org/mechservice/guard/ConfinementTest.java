package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

public class ConfinementTest {
  private static final Confinement NONE = Confinement.none("nothing is installed");

  /** Without it the probe could find a wall where there is none. */
  @Test
  void probeGetsOutOfAnOrdinaryProcessInEveryWayItKnows() throws Exception {
    assumeTrue(System.getProperty("os.name").equals("Linux"), "needs /etc/passwd");
    assertThat(NONE.tryToGetOut())
        .startsWith("it could see /etc/passwd, see ")
        .contains("open a connection, write a file, ")
        .endsWith("start a process");
  }

  /** Returns the ways tried, each with whether it works. */
  public static Map<String, Boolean> ways(Confinement wall, String mechanism) throws Exception {
    Path file = Files.writeString(Files.createTempFile("host", ".txt"), "secret");
    try (ServerSocket listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      List<String> arguments =
          List.of(
              Integer.toString(listening.getLocalPort()), file.toString(), "/usr/bin", mechanism);
      Process escaping =
          wall.command(new WorkerBounds(1 << 27, 60), EscapeAttempts.class, arguments).start();
      escaping.getOutputStream().close();
      String said = new String(escaping.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      Map<String, Boolean> ways = new LinkedHashMap<>();
      said.lines()
          .forEach(line -> ways.put(line.substring(2), line.startsWith(EscapeAttempts.WORKED)));
      return ways;
    } finally {
      Files.delete(file);
    }
  }

  /**
   * Bubblewrap that is killed before its wall is complete leaves a half of itself, which waits for
   * the other one for ever and holds the streams: who reads from the process would wait with it.
   */
  @Test
  void processesThatAreKilledWhileTheyStartCloseTheirStreamsAndLeaveNothingBehind()
      throws Exception {
    Confinement wall = Confinement.ofThisMachine();
    assumeTrue(wall.stands(), () -> "no confinement on this machine: " + wall.text());
    String mark = "mark-" + UUID.randomUUID();
    List<FutureTask<byte[]>> said = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Process started =
          Confinement.start(
              wall.command(
                  new WorkerBounds(1 << 26, 60), ConfinementProbe.class, List.of("0", mark)));
      FutureTask<byte[]> reading = new FutureTask<>(started.getInputStream()::readAllBytes);
      new Thread(reading).start();
      TimeUnit.MICROSECONDS.sleep(500L * i);
      ProcessHandle.of(started.pid()).ifPresent(ProcessHandle::destroyForcibly);
      said.add(reading);
    }
    for (FutureTask<byte[]> reading : said) {
      assertThat(reading.get(60, TimeUnit.SECONDS)).isNotNull();
    }
    long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    while (!marked(mark).isEmpty() && System.nanoTime() < until) {
      Thread.sleep(20);
    }
    assertThat(marked(mark)).isEmpty();
  }

  /** Returns the processes one of whose words is a mark. */
  private static List<Path> marked(String mark) throws IOException {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(Path.of("/proc"), "[0-9]*")) {
      for (Path process : processes) {
        try {
          if (Files.readString(process.resolve("cmdline")).contains(mark)) {
            found.add(process);
          }
        } catch (IOException e) {
          // It has just ended, or its words are no text.
        }
      }
    }
    return found;
  }

  @ValueSource(strings = {"POSIX_SPAWN", "VFORK", "FORK"})
  @ParameterizedTest
  void programThatUsesAllOfJavaReachesNothingOutside(String launchMechanism) throws Exception {
    Confinement wall = Confinement.ofThisMachine();
    assumeTrue(wall.stands(), () -> "no confinement on this machine: " + wall.text());
    assertThat(ways(wall, launchMechanism)).hasSize(30).doesNotContainValue(true);
  }

  /** So the ways are ways. */
  @Test
  void sameProgramReachesMuchFromAnOrdinaryProcess() throws Exception {
    assumeTrue(System.getProperty("os.name").equals("Linux"), "the ways are those of Linux");
    Map<String, Boolean> ways = ways(NONE, "POSIX_SPAWN");
    ways.values().removeIf(works -> !works);
    assertThat(ways)
        .containsKeys(
            "reads the users",
            "reads a file of the host",
            "lists a folder of the host",
            "sees other processes",
            "writes a file",
            "writes where it is",
            "connects to the loopback interface",
            "sends a datagram",
            "listens",
            "opens a socket in the file system",
            "opens a channel",
            "runs a shell",
            "loads a library of its own");
  }

  @Test
  void classesOfUsersDoNotRunWithoutAWallUnlessTheOperatorSaysSo() {
    assertThat(UserCodePolicy.CONFINED.runsBehind(NONE)).isFalse();
    assertThat(UserCodePolicy.UNCONFINED.runsBehind(NONE)).isTrue();
    assertThat(UserCodePolicy.REFUSED.runsBehind(NONE)).isFalse();
    assertThat(UserCodePolicy.CONFINED.text(NONE)).isEqualTo("not run: nothing is installed");
    assertThat(UserCodePolicy.UNCONFINED.text(NONE)).isEqualTo("unconfined: nothing is installed");
  }

  @Test
  void wallOfThisMachineHoldsAgainstTheProbe() throws Exception {
    Confinement wall = Confinement.ofThisMachine();
    assumeTrue(wall.stands(), () -> "no confinement on this machine: " + wall.text());
    assertThat(wall.tryToGetOut()).isEqualTo(ConfinementProbe.HELD);
    assertThat(UserCodePolicy.CONFINED.runsBehind(wall)).isTrue();
    assertThat(UserCodePolicy.CONFINED.text(wall)).startsWith("confined: bubblewrap");
  }
}
