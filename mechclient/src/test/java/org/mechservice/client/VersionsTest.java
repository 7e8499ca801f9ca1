package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.RunResult;
import org.mechservice.solver.api.run.Outcome;

/** A client at servers of other versions of the contract. */
class VersionsTest {
  @TempDir private Path cacheFolder;

  @ValueSource(strings = {"1.1", "1.12"})
  @ParameterizedTest
  void otherMinorVersionWorks(String version) throws IOException {
    try (ScriptedServer server = new ScriptedServer()) {
      server.apiVersion = version;
      try (MechConnection connection =
              MechConnection.open(server.address(), new JarCache(cacheFolder));
          MechSession session = connection.openSession()) {
        connection.acceptSolversOf(server.key.getPublic());
        session.loadModel("square.xml", new byte[] {'<'});
        Rows remote = new Rows();
        RunResult result = session.prepareRemoteRun(SimulationOptions.asInFile()).toEnd(remote);
        assertThat(result.outcome()).isEqualTo(new Outcome.Completed());
        assertThat(remote.rows).hasSize(ScriptedServer.ROWS);
        assertThat(result.report()).containsEntry("where", "remote, host here");
        RunResult local = session.prepareLocalRun(SimulationOptions.asInFile()).toEnd(new Rows());
        assertThat(local.report())
            .containsEntry("where", "local, compiled by host here")
            .containsEntry("modelSha256", "abc")
            .containsEntry("formulationReason", "a tree")
            .containsKeys("t1c", "t1s", "t2c", "t2s", "tcc", "tL");
      }
      assertThat(server.happened).contains("in one call");
    }
  }

  @ValueSource(strings = {"0.9", "2.0", "nonsense"})
  @ParameterizedTest
  void otherMajorVersionIsRefusedWithBothVersions(String version) {
    try (ScriptedServer server = new ScriptedServer()) {
      server.apiVersion = version;
      assertThatThrownBy(() -> MechConnection.open(server.address(), new JarCache(cacheFolder)))
          .isInstanceOf(ServerLostException.class)
          .hasMessageStartingWith("S-005")
          .hasMessageContaining("speaks API " + version + ", this client 1.")
          .hasMessageContaining("use the client of server version 0.0");
    }
  }
}
