package org.mechservice.cli.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

@Tag("slow")
class KeysCommandTest {
  private final StringWriter err = new StringWriter();
  private Path keys;

  @BeforeEach
  void name(@TempDir Path folder) {
    keys = folder.resolve("keys");
  }

  private int mech(String... words) {
    return Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err), words);
  }

  @Test
  void someoneOfEachKindIsMadeIfNobodyIsNamed() {
    assertThat(mech("keys", keys.toString())).isZero();
    assertThat(keys.toFile().list())
        .containsExactlyInAnyOrder("ca", "server", "client", "monitor", "admin");
  }

  /** Whoever adds a user must not make an administrator without knowing. */
  @Test
  void onlyWhoIsNamedIsMade() {
    assertThat(mech("keys", keys.toString(), "--client", "ann")).isZero();
    assertThat(mech("keys", keys.toString(), "--client", "bob")).isZero();
    assertThat(keys.toFile().list()).containsExactlyInAnyOrder("ca", "ann", "bob");
  }

  @Test
  void folderThatCannotBeMadeIsSaidInWords() throws Exception {
    Files.writeString(keys, "no folder");
    assertThat(mech("keys", keys.toString(), "--client", "ann")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-155 ").doesNotContain("Exception").hasLineCount(1);
  }
}
