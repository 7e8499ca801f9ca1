package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.sim.host.HostOptions;

/** Who may administer a server over TLS, with the keys that {@code mech keys} makes. */
@Tag("slow")
class AdminRightsTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private int admin(MechServerProcess server, String identity, String... words) {
    List<String> line = new ArrayList<>(List.of("admin", "--timeout", "60", "--tls", identity));
    line.addAll(List.of("--server", server.url()));
    line.addAll(List.of(words));
    return mech(line.toArray(String[]::new));
  }

  @Test
  void administratorsActAndMonitorsLookAndOthersAreRefusedEverything(@TempDir Path keys) {
    assertThat(mech("keys", keys.toString())).isZero();
    try (MechServerProcess server =
        MechServerProcess.start(
            new ServerSettings(
                "127.0.0.1",
                0,
                new HostOptions("secure", 1),
                PlacementPolicy.LEAST_LOADED,
                Optional.empty(),
                Optional.empty(),
                Optional.of(TlsIdentity.load(keys.resolve("server")))))) {
      String admin = keys.resolve("admin").toString();
      String client = keys.resolve("client").toString();
      assertThat(admin(server, admin, "servers")).as(err.toString()).isZero();
      assertThat(out.toString()).contains("secure");
      assertThat(admin(server, admin, "drain")).as(err.toString()).isZero();
      for (String line :
          List.of(
              "servers",
              "limits",
              "undrain",
              "shutdown",
              "placement order",
              "stop abcd1234",
              "drain secure",
              "show abcd1234")) {
        assertThat(admin(server, client, line.split(" ", -1))).isEqualTo(ExitStatus.SERVER);
        assertThat(err.toString()).as(line).startsWith("S-153 ").hasLineCount(1);
      }
      String monitor = keys.resolve("monitor").toString();
      for (String line : List.of("status", "servers", "hosts", "sims", "logs", "limits")) {
        assertThat(admin(server, monitor, line)).as(err.toString()).isZero();
      }
      for (String line : List.of("undrain", "shutdown", "placement order", "limits queue=1")) {
        assertThat(admin(server, monitor, line.split(" ", -1))).isEqualTo(ExitStatus.SERVER);
        assertThat(err.toString()).as(line).startsWith("S-153 ").hasLineCount(1);
      }
      assertThat(admin(server, admin, "servers")).as(err.toString()).isZero();
      assertThat(out.toString()).contains("draining");
      assertThat(admin(server, admin, "logs")).as(err.toString()).isZero();
      assertThat(out.toString())
          .containsPattern("WARN +server +S-153 \"client\" \\(client\\) at 127\\.0\\.0\\.1:\\d+")
          .contains("was refused shutdownServer(30)", "was refused setLimits(, queue=1)");
    }
  }
}
