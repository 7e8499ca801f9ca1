package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.JarCache;

/**
 * Two users of one server over TLS, of whom one does everything that harms, for ten minutes: the
 * other gets at least half of what he gets alone, with the right bits.
 */
@Tag("soak")
class HostileNeighbourTest {
  private static final Duration ALONE = Duration.ofMinutes(1);

  /** A measurement is of ten minutes; fewer show whether each attack arrives. */
  private static final Duration TOGETHER = Duration.ofMinutes(Long.getLong("hostile.minutes", 10));

  private static final int HEAP_MEGABYTES = 512;

  @TempDir Path folder;

  private int models;

  @Test
  void neighbourGetsAtLeastHalfOfWhatHeGetsAlone() throws Exception {
    TlsKeys keys = TlsKeys.make(folder.resolve("keys"), "ann", "eve");
    try (ServiceJvm server =
            ServiceJvm.start(
                List.of(),
                HEAP_MEGABYTES,
                List.of("-XX:TieredStopAtLevel=4"),
                "server",
                "--listen",
                "127.0.0.1:0",
                "--capacity",
                "2",
                "--allow-user-code",
                "--tls",
                keys.of("server"));
        MechConnection ann =
            MechConnection.open(
                server.address(), new JarCache(folder.resolve("jars")), keys.identity("ann"))) {
      List<Long> right;
      try (MechSession session = ann.openSession()) {
        session.loadModel(Runs.PENDULUM);
        right = Runs.bits(session, SimulationOptions.asInFile(), false);
      }
      throughput(ann, right, ALONE.dividedBy(2)); // what runs often is compiled
      double before = throughput(ann, right, ALONE);
      Process eve = hostile(server.address(), keys.of("eve"));
      double together;
      String attempts;
      try {
        TimeUnit.SECONDS.sleep(5);
        together = throughput(ann, right, TOGETHER);
        eve.getOutputStream().close();
        attempts = new String(eve.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
      } finally {
        eve.destroyForcibly();
      }
      TimeUnit.SECONDS.sleep(15);
      double after = throughput(ann, right, ALONE);
      String[] counts = attempts.split(" ", -1);
      write(before, together, after, counts);
      assertThat(counts).as("each attack has reached what it is for").doesNotContain("0");
      assertThat(server.alive()).isTrue();
      assertThat(server.messages()).doesNotContain("S-001").doesNotContain("OutOfMemoryError");
      assertThat(together).isGreaterThanOrEqualTo((before + after) / 2 / 2);
    }
  }

  /** It has machines of its own, so it takes little of this one. */
  private static Process hostile(String address, String keys) throws IOException {
    return new ProcessBuilder(
            "nice",
            "-n",
            "19",
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx512m",
            "-cp",
            System.getProperty("java.class.path"),
            HostileNeighbour.class.getName(),
            address,
            keys)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  /** Sets up models that the server does not know and runs them; returns how many a minute. */
  private double throughput(MechConnection ann, List<Long> right, Duration time)
      throws IOException {
    String text = Files.readString(Runs.PENDULUM);
    long begin = System.nanoTime();
    int done = 0;
    while (System.nanoTime() - begin < time.toNanos()) {
      String other = text.replace("</MechML>", "<!-- " + models++ + " --></MechML>");
      try (MechSession session = ann.openSession()) {
        session.loadModel("pendulum.xml", other.getBytes(StandardCharsets.UTF_8));
        assertThat(Runs.bits(session, SimulationOptions.asInFile(), false)).isEqualTo(right);
      }
      done++;
    }
    return done / ((System.nanoTime() - begin) * 1e-9 / 60);
  }

  private static void write(double before, double together, double after, String[] counts)
      throws IOException {
    SoakPage page =
        new SoakPage(
            "A hostile neighbour",
            "One server with two places, over TLS, which runs classes of users. Ann sets up a model"
                + " that the server does not know yet and runs it, again and again, one at a time;"
                + " each of her runs has the right rows to the last bit. Eve, an ordinary user on a"
                + " process of the lowest priority (her machines would be others), does all of this"
                + " at once: eight texts of 4 000 closed loops, sources that swell in the compiler,"
                + " runs without end, as many as she may have, classes that loop without end, in"
                + " their run or before it, classes that fail with long texts, all sessions that"
                + " she gets, robots that are none, and damaged messages.",
            0);
    page.line("| | Ann's models and runs a minute |").line("|---|---|");
    page.line("| alone, a minute before | %.1f |", before);
    page.line("| beside Eve, %d minutes | %.1f |", TOGETHER.toMinutes(), together);
    page.line("| alone, a minute after | %.1f |", after);
    page.line(
        "%nBeside Eve, who made %s attempts, Ann got %.2f of what she gets alone; at least half is"
            + " asked. The server went on, without an incident. Of Eve's classes %s swelled in the"
            + " compiler until it gave up, one was seen in its loop %s times, %s hung at their"
            + " first row until their session ended, and %s failed with long texts.",
        counts[0], together / ((before + after) / 2), counts[1], counts[2], counts[3], counts[4]);
    page.write("service-hostile-neighbour.md");
  }
}
