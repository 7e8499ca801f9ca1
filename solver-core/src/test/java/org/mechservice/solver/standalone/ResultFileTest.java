package org.mechservice.solver.standalone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.api.Variable;

class ResultFileTest {
  private static final List<Variable> COLUMNS = List.of(new Variable("t", "s"));

  @TempDir private Path folder;

  @Test
  void isNotFoundUnderItsNameBeforeItIsKept() throws IOException {
    Path target = folder.resolve("r.csv");
    try (ResultFile file = new ResultFile(target)) {
      file.begin(COLUMNS);
      file.row(new double[] {0});
      assertThat(target).doesNotExist();
    }
  }

  @Test
  void leavesNothingBehindWhenItIsNotKept() throws IOException {
    try (ResultFile file = new ResultFile(folder.resolve("r.csv"))) {
      file.begin(COLUMNS);
    }
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void keptFileHasTheHashReportedAndItsUnitsBesideIt() throws Exception {
    Path target = folder.resolve("r.csv");
    String hash;
    try (ResultFile file = new ResultFile(target)) {
      file.begin(COLUMNS);
      file.row(new double[] {0.5});
      hash = file.keep();
    }
    byte[] content = Files.readAllBytes(target);
    assertThat(new String(content, StandardCharsets.UTF_8)).isEqualTo("t\r\n0.5\r\n");
    assertThat(hash)
        .isEqualTo(HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content)));
    assertThat(folder.resolve("r.units.json")).hasContent("{\n  \"t\": \"s\"\n}");
    assertThat(folder.toFile().list()).hasSize(2);
  }

  @Test
  void namesTheFolderThatIsMissing() {
    assertThatThrownBy(() -> new ResultFile(folder.resolve("none/r.csv")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("none");
  }
}
