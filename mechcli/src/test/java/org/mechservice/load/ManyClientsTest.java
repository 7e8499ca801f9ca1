package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.jar.JarCache;

/**
 * Many clients at once, each with connections of its own, half of them running the model at the
 * server and half at home, get what one client alone gets, to the last bit.
 */
@Tag("slow")
class ManyClientsTest {
  private static final int KINDS = 4;

  @TempDir Path folder;

  /** How long a client's whole work took, from opening its connection to the last row. */
  private record Work(boolean local, double seconds) {}

  @Test
  void someClientsGetWhatOneAloneGets() throws Exception {
    assertThat(work(6)).hasSize(6);
  }

  @Tag("soak")
  @Test
  void twoHundredClientsGetWhatOneAloneGets() throws Exception {
    long start = System.nanoTime();
    List<Work> work = work(200);
    double total = (System.nanoTime() - start) * 1e-9;
    SoakPage page =
        new SoakPage(
            "Two hundred clients at once",
            "200 clients in one process, each with an ORB and connections of its own, connect, wait"
                + " for each other, and then all at once open a session, load the pendulum (one of"
                + " four tolerances) and simulate it: every second one at the service (a server"
                + " with `-Xmx256m` and a host, 2 places each), the others at home with the JARs"
                + " they fetch. Every row is equal, to the last bit, to that of a single run done"
                + " before.",
            0);
    page.line("| | remote | local |").line("|---|---|---|");
    page.line(
        "| clients without error, all bits equal | %d | %d |",
        count(work, false), count(work, true));
    for (int percent : new int[] {50, 90, 100}) {
      page.line(
          "| %s of a client's work, session to last row | %.2f s | %.2f s |",
          percent == 50 ? "median" : percent == 100 ? "longest" : percent + " %",
          quantile(work, false, percent),
          quantile(work, true, percent));
    }
    page.line("| all together, with 200 connections opened | %.1f s | |", total);
    page.write("service-many-clients.md");
  }

  private static long count(List<Work> work, boolean local) {
    return work.stream().filter(done -> done.local() == local).count();
  }

  private static double quantile(List<Work> work, boolean local, int percent) {
    double[] sorted =
        work.stream()
            .filter(done -> done.local() == local)
            .mapToDouble(Work::seconds)
            .sorted()
            .toArray();
    return sorted[Math.min(sorted.length - 1, sorted.length * percent / 100)];
  }

  private List<Work> work(int clients) throws Exception {
    String[] limits = {
      "--capacity",
      "2",
      "--limit",
      "clientRuns=-1",
      "--limit",
      "clientSessions=-1",
      "--limit",
      "clientBuilds=-1"
    };
    ExecutorService threads = Executors.newFixedThreadPool(clients);
    try (ServiceJvm server = ServiceJvm.server(256, limits);
        ServiceJvm host = ServiceJvm.host(server.address(), "second", limits)) {
      List<List<Long>> alone = alone(server.address());
      CyclicBarrier all = new CyclicBarrier(clients);
      List<Future<Work>> going = new ArrayList<>();
      for (int i = 0; i < clients; i++) {
        int number = i;
        going.add(threads.submit(() -> client(server.address(), number, all, alone)));
      }
      List<Work> done = new ArrayList<>();
      for (Future<Work> one : going) {
        done.add(one.get(10, TimeUnit.MINUTES));
      }
      assertThat(host.alive()).isTrue();
      return done;
    } finally {
      threads.shutdownNow();
    }
  }

  private List<List<Long>> alone(String url) throws Exception {
    List<List<Long>> bits = new ArrayList<>();
    try (MechConnection connection = MechConnection.open(url, new JarCache(folder));
        MechSession session = connection.openSession()) {
      session.loadModel(Runs.PENDULUM);
      for (int kind = 0; kind < KINDS; kind++) {
        bits.add(Runs.bits(session, Runs.kind(kind), false));
      }
    }
    return bits;
  }

  private Work client(String url, int number, CyclicBarrier all, List<List<Long>> alone)
      throws Exception {
    boolean local = number % 2 == 1;
    try (MechConnection connection =
        MechConnection.open(url, new JarCache(folder.resolve("client" + number)))) {
      all.await(5, TimeUnit.MINUTES);
      long start = System.nanoTime();
      try (MechSession session = connection.openSession()) {
        session.loadModel(Runs.PENDULUM);
        int kind = number / 2;
        assertThat(Runs.bits(session, Runs.kind(kind), local))
            .as(String.format(Locale.ROOT, "rows of client %d", number))
            .isEqualTo(alone.get(kind % KINDS));
      }
      return new Work(local, (System.nanoTime() - start) * 1e-9);
    }
  }
}
