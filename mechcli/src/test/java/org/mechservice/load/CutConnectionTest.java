package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** What becomes of the rows of a run when the connection to its server is cut meanwhile. */
@Tag("slow")
class CutConnectionTest {
  /** Some 60 MB of rows, which take several blocks. */
  private static final double OUTPUT_STEP = 0.01;

  private static final SimulationOptions LARGE =
      SimulationOptions.asInFile().endTime(7000).outputStep(OUTPUT_STEP);

  private static final long EVERY = 100_000;

  @TempDir private Path folder;

  /** Counts rows and cuts the connection now and then. */
  private static final class Cutting implements ResultSink {
    private final Relay relay;
    private final boolean forGood;
    private long rows;
    private int cuts;

    Cutting(Relay relay, boolean forGood) {
      this.relay = relay;
      this.forGood = forGood;
    }

    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) throws IOException {
      assertThat(Math.round(values[0] / OUTPUT_STEP)).isEqualTo(rows);
      rows++;
      if (rows % EVERY == 0) {
        cuts++;
        if (forGood) {
          relay.close();
        } else {
          cutSoon();
        }
      }
    }

    /** So that the cut meets a block that is under way, too, not only the pause between two. */
    private void cutSoon() {
      Thread cutter =
          new Thread(
              () -> {
                try {
                  Thread.sleep(cuts);
                  relay.cutConnections();
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                } catch (InterruptedException e) {
                  Thread.currentThread().interrupt();
                }
              });
      cutter.setDaemon(true);
      cutter.start();
    }
  }

  private interface Use {
    void of(RemoteRun run, Relay relay) throws Exception;
  }

  private void withRelayedRun(Use use) throws Exception {
    try (Relay relay = new Relay(Relay.anyPortOf("127.0.0.2"), 0);
        ServiceJvm server = named(relay.port());
        MechConnection connection = connected(relay, server);
        MechSession session = connection.openSession()) {
      session.loadModel(Runs.PENDULUM);
      try (RemoteRun run = session.prepareRemoteRun(LARGE)) {
        use.of(run, relay);
      }
    }
  }

  /** Starts a server that says it is at the relay, whose port is then its own, too. */
  private static ServiceJvm named(int port) throws IOException {
    return ServiceJvm.start(
        List.of(),
        128,
        List.of("-Djacorb.ior_proxy_host=127.0.0.2", "-Djacorb.ior_proxy_port=" + port),
        "server",
        "--port",
        Integer.toString(port));
  }

  private MechConnection connected(Relay relay, ServiceJvm server) {
    relay.leadTo(server.port());
    return MechConnection.open("127.0.0.2:" + relay.port(), new JarCache(folder.resolve("cache")));
  }

  @Test
  void everyRowArrivesOnceAlthoughConnectionsAreCut() throws Exception {
    withRelayedRun(
        (run, relay) -> {
          Cutting rows = new Cutting(relay, false);
          run.toEnd(rows);
          assertThat(rows.cuts).isEqualTo(7);
          assertThat(rows.rows).isEqualTo(700_001);
        });
  }

  @Test
  void serverThatStaysAwayIsLostWithTheRowsUpToThenHandedOver() throws Exception {
    withRelayedRun(
        (run, relay) -> {
          Cutting rows = new Cutting(relay, true);
          assertThatThrownBy(() -> run.toEnd(rows))
              .isInstanceOf(ServerLostException.class)
              .hasMessageStartingWith("S-031");
          assertThat(rows.rows).isGreaterThanOrEqualTo(EVERY);
        });
  }
}
