package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.orb.ServiceOrb;

/** What one client does to a server, as users start both, and what the others notice of it. */
class HostileTenantIT {
  @TempDir private Path folder;

  @Test
  void textOfAClassSilencesNoAudit() throws Exception {
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    DraggedBob.writeSource(
        folder,
        "",
        "",
        "throw new IllegalStateException(\"\\ud800\\ud800 \\u0000 \\u202e \\r\\n\\u001b]0;x\\u0007\");");
    int port = Service.freePort();
    Path audit = folder.resolve("audit.jsonl");
    try (Terminal.Running server =
        Service.startServer(
            folder, port, "--allow-user-code=unconfined", "--audit", audit.toString())) {
      Terminal terminal = new Terminal(folder);
      String url = Service.url(port);
      Terminal.Ended thrown =
          terminal.mech("simulate", "m.xml", "--server", url, "--user-code", ".");
      assertThat(thrown.exitStatus()).as(thrown.toString()).isEqualTo(1);
      assertThat(thrown.stdout() + thrown.stderr()).doesNotContain("\u001b");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--out", "r.csv")
          .orFail();
      server.awaitThat("the end of the other run", () -> read(audit).contains("sim-done"));
    }
    assertThat(Files.readAllLines(audit))
        .allSatisfy(line -> assertThat(JsonParser.parseString(line).isJsonObject()).isTrue())
        .anyMatch(line -> line.contains("sim-failed") && line.contains("\ufffd"));
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(audit)))
        .isEqualTo("rw-------");
  }

  /**
   * One client that opens all the sessions it can and keeps them: another one still gets in, the
   * operator sees who it is, and ends it.
   */
  @Test
  void clientThatTakesAllSessionsLeavesSomeAndIsEndedByTheOperator() throws Exception {
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port);
        ServiceOrb orb = ServiceOrb.client()) {
      assertThat(server.stdout()).contains(url);
      int opened = 0;
      Optional<LimitExceeded> refusal = Optional.empty();
      while (refusal.isEmpty() && opened < 1000) {
        try {
          orb.connect(url).createSession("mallory", "", null).sessionId();
          opened++;
        } catch (LimitExceeded e) {
          refusal = Optional.of(e);
        }
      }
      assertThat(opened).isEqualTo(48);
      assertThat(refusal.orElseThrow().limitName).isEqualTo("clientSessions");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();

      String listed = terminal.mech("admin", "--server", url, "sessions").orFail().stdout();
      assertThat(listed.lines().filter(line -> line.contains("mallory"))).hasSize(48);
      terminal
          .mech("admin", "--server", url, "end", "--user", "mallory", "--reason", "all of them")
          .orFail();
      assertThat(terminal.mech("admin", "--server", url, "sessions").orFail().stdout())
          .doesNotContain("mallory");
      Terminal.Ended nobody = terminal.mech("admin", "--server", url, "end", "--user", "mallory");
      assertThat(nobody.exitStatus()).as(nobody.toString()).isNotZero();
      assertThat(nobody.stderr()).contains("S-130");
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "";
    }
  }
}
