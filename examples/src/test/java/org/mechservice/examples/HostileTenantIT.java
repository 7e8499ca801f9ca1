package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "";
    }
  }
}
