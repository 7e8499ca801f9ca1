package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RemoteRun;

/**
 * The service from far away: a relay on another loopback address, at which the server says it is,
 * delays every byte both ways and counts how often the client waits for an answer.
 */
@Tag("slow")
class DelayTest {
  private static final int MOST_ROUND_TRIPS = 6;

  /** 100 001 rows of 11 columns: 8.8 MB. */
  private static final SimulationOptions LARGE =
      SimulationOptions.asInFile().endTime(1000).outputStep(0.01).relativeTolerance(1e-4);

  @TempDir Path folder;

  /** What it took a client, with the connection. */
  private record Cost(int roundTrips, double setUp, double run, double megabytesPerSecond) {}

  @Test
  void remoteRunIsSetUpInFewRoundTrips() throws Exception {
    assertThat(cost(0, false, SimulationOptions.asInFile()).roundTrips())
        .isBetween(3, MOST_ROUND_TRIPS);
  }

  @Test
  void localRunIsSetUpInFewRoundTrips() throws Exception {
    assertThat(cost(0, true, SimulationOptions.asInFile()).roundTrips())
        .isBetween(3, MOST_ROUND_TRIPS);
  }

  @Tag("soak")
  @Test
  void serviceIsMeasuredFromFarAway() throws Exception {
    SoakPage page =
        new SoakPage(
            "The service from far away",
            "Client and server on one machine; a relay between them delays every byte, so that a"
                + " round trip takes the time given, opening a TCP connection too, and counts how"
                + " often the client waits for an answer. Set-up: from nothing to a run that is"
                + " ready to start, for `local` with both JARs fetched. Run: the pendulum to its"
                + " last row. Streaming: 100001 rows of a finished run, 8.8 MB, in blocks of a MiB,"
                + " one asked for after the other. Network namespaces would delay in the kernel;"
                + " this machine's has no netem.",
            0);
    page.line(
        "| round trip | set-up remote | round trips | set-up local | round trips | run | streaming"
            + " |");
    page.line("|---|---|---|---|---|---|---|");
    for (int roundTrip : new int[] {0, 20, 80}) {
      Cost remote = cost(roundTrip / 2.0, false, SimulationOptions.asInFile());
      Cost local = cost(roundTrip / 2.0, true, SimulationOptions.asInFile());
      Cost large = cost(roundTrip / 2.0, false, LARGE);
      page.line(
          "| %d ms | %.0f ms | %d | %.0f ms | %d | %.0f ms | %.1f MB/s |",
          roundTrip,
          remote.setUp() * 1e3,
          remote.roundTrips(),
          local.setUp() * 1e3,
          local.roundTrips(),
          remote.run() * 1e3,
          large.megabytesPerSecond());
      assertThat(List.of(remote.roundTrips(), local.roundTrips()))
          .allMatch(trips -> trips <= MOST_ROUND_TRIPS);
    }
    page.write("service-far-away.md");
  }

  private Cost cost(double delay, boolean local, SimulationOptions options) throws Exception {
    try (Relay relay = new Relay(Relay.anyPortOf("127.0.0.2"), delay);
        ServiceJvm server =
            ServiceJvm.start(
                List.of(),
                256,
                List.of(
                    "-Djacorb.ior_proxy_host=127.0.0.2", "-Djacorb.ior_proxy_port=" + relay.port()),
                "server",
                "--port",
                Integer.toString(relay.port()))) {
      relay.leadTo(server.port());
      warmUp(relay.port());
      int before = relay.roundTrips();
      long start = System.nanoTime();
      try (MechConnection connection =
              MechConnection.open(
                  "127.0.0.2:" + relay.port(),
                  new JarCache(folder.resolve("cache" + System.nanoTime())));
          MechSession session = connection.openSession()) {
        session.loadModel(Runs.PENDULUM);
        try (PreparedRun run =
            local ? session.prepareLocalRun(options) : session.prepareRemoteRun(options)) {
          int roundTrips = relay.roundTrips() - before;
          double setUp = (System.nanoTime() - start) * 1e-9;
          if (options.equals(LARGE)) {
            awaitEnd((RemoteRun) run);
          }
          Runs.Kept rows = new Runs.Kept();
          start = System.nanoTime();
          run.toEnd(rows);
          double seconds = (System.nanoTime() - start) * 1e-9;
          return new Cost(roundTrips, setUp, seconds, rows.bits().size() * 8e-6 / seconds);
        }
      }
    }
  }

  private static void awaitEnd(RemoteRun run) throws InterruptedException {
    run.start();
    while (run.progress().state() != RunState.DONE) {
      Thread.sleep(100);
    }
  }

  /** Neither the compiler's first minute nor that of the client's own classes is the network's. */
  private void warmUp(int port) throws Exception {
    try (MechConnection connection =
            MechConnection.open("127.0.0.2:" + port, new JarCache(folder.resolve("warm")));
        MechSession session = connection.openSession()) {
      session.loadModel(Runs.PENDULUM);
      Runs.bits(session, SimulationOptions.asInFile(), false);
    }
  }
}
