package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.load.ServiceJvm.Inside;

/**
 * Client, worker, host and server are killed at random moments. No completed result is lost or
 * wrong, nothing is left over, and who has nothing to do with it does not notice.
 */
@Tag("slow")
class KilledAtRandomTest {
  private static final long SEED = 7_2026_11_22;

  @TempDir Path folder;

  /** Somebody who is killed, and what must hold then. */
  private enum Killed {
    CLIENT("client") {
      @Override
      void in(Killing killing) throws Exception {
        killing.client();
      }
    },
    WORKER("worker") {
      @Override
      void in(Killing killing) throws Exception {
        killing.worker();
      }
    },
    HOST("host") {
      @Override
      void in(Killing killing) throws Exception {
        killing.hostProcess();
      }
    },
    SERVER("server") {
      @Override
      void in(Killing killing) throws Exception {
        killing.serverProcess();
      }
    };

    private final String label;

    Killed(String label) {
      this.label = label;
    }

    abstract void in(Killing killing) throws Exception;
  }

  @Test
  void killedOnceEach() throws Exception {
    try (Killing killing = new Killing(SEED, folder)) {
      Inside server = killing.insideServer();
      for (Killed killed : Killed.values()) {
        killed.in(killing);
        killing.assertWitnessSawNothing();
        if (killed == Killed.HOST) {
          assertThat(killing.insideServer().objects()).isEqualTo(server.objects());
        }
      }
    }
  }

  @Tag("soak")
  @Test
  void killedAHundredTimes() throws Exception {
    Random random = new Random(SEED);
    Map<Killed, Integer> times = new EnumMap<>(Killed.class);
    try (Killing killing = new Killing(SEED, folder)) {
      for (Killed killed : Killed.values()) {
        killed.in(killing);
        killing.assertWitnessSawNothing();
      }
      Inside witnessBefore = killing.insideWitness();
      Inside victimBefore = killing.insideVictim();
      Inside serverBefore = killing.insideServer();
      for (int round = 0; round < 100; round++) {
        Killed killed = Killed.values()[random.nextInt(Killed.values().length)];
        times.merge(killed, 1, Integer::sum);
        killed.in(killing);
        killing.assertWitnessSawNothing();
      }
      Thread.sleep((Killing.LEASE_SECONDS + 2) * 1000L); // leases of those who are dead end
      Inside witness = killing.insideWitness();
      Inside victim = killing.insideVictim();
      Inside server = killing.insideServer();
      write(
          times,
          killing,
          List.of(witnessBefore, witness, victimBefore, victim, serverBefore, server));
      assertNoMore(witnessBefore, witness);
      assertNoMore(victimBefore, victim);
      assertNoMore(serverBefore, server);
    }
  }

  private static void assertNoMore(Inside before, Inside after) {
    assertThat(after.objects()).as("CORBA objects").isLessThanOrEqualTo(before.objects());
    assertThat(after.threads()).as("threads").isLessThanOrEqualTo(before.threads() + 3);
    assertThat(after.files()).as("open files").isLessThanOrEqualTo(before.files() + 3);
  }

  private static void write(Map<Killed, Integer> times, Killing killing, List<Inside> inside)
      throws Exception {
    SoakPage page =
        new SoakPage(
            "Killed at random",
            "A server, a host `victim` with a spool folder, and a host `witness`. In 100 runs a"
                + " client, a worker, the victim or the server gets `kill -9` up to 1.5 s after a"
                + " simulation of about a second was started, and is started again. Each time: a run"
                + " that had completed is taken up again with the same bits; one that was cut off"
                + " says so, and its rows are the first of the whole run's, bit by bit; a dead"
                + " client's run is cancelled; a run whose server is killed goes on to its end; no"
                + " worker process and no half-written file is left; and a client of the witness, connected all"
                + " the time, gets its own results to the last bit.",
            SEED);
    page.line("| killed | times |").line("|---|---|");
    for (Killed killed : Killed.values()) {
      page.line("| %s | %d |", killed.label, times.getOrDefault(killed, 0));
    }
    page.line(
        "%nOf the runs whose host was killed %d had completed, %d were cut off (and the"
            + " others had not begun); none was lost or wrong.%n",
        killing.completed(), killing.cutOff());
    page.line("| process | CORBA objects before, after | threads | open files | heap in use |");
    page.line("|---|---|---|---|---|");
    List<String> names = List.of("witness", "victim (the last one)", "server (the last one)");
    for (int i = 0; i < names.size(); i++) {
      Inside before = inside.get(2 * i);
      Inside after = inside.get(2 * i + 1);
      page.line(
          "| %s | %d, %d | %d, %d | %d, %d | %.1f, %.1f MB |",
          names.get(i),
          before.objects(),
          after.objects(),
          before.threads(),
          after.threads(),
          before.files(),
          after.files(),
          before.heapBytes() * 1e-6,
          after.heapBytes() * 1e-6);
    }
    page.write("service-killed.md");
  }
}
