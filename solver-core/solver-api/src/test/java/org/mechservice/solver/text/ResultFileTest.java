package org.mechservice.solver.text;

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
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.api.result.Variable;

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

  /** The file that grows has a longer name than the one asked for. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void folderThatRefusesTheFileIsNamedWithItsReason() {
    Path target = folder.resolve("r".repeat(240) + ".csv");
    assertThatThrownBy(() -> new ResultFile(target))
        .hasMessage("S-064 cannot write in folder " + folder + ": File name too long");
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

  /** Writes rows without end into the file that is named. */
  static final class EndlessRows {
    private EndlessRows() {}

    public static void main(String[] args) throws IOException {
      try (ResultFile file = new ResultFile(Path.of(args[0]))) {
        file.begin(COLUMNS);
        for (double t = 0; ; t++) {
          file.row(new double[] {t});
        }
      }
    }
  }

  /** A bound for the size of files stands for a full disk. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void rowsThatCameBeforeTheDiskWasFullAreKeptAndNamed() throws Exception {
    Process writer =
        new ProcessBuilder(
                "sh",
                "-c",
                "ulimit -f 64; exec \"$@\"",
                "sh",
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty("java.class.path"),
                EndlessRows.class.getName(),
                folder.resolve("r.csv").toString())
            .redirectErrorStream(true)
            .start();
    String said = new String(writer.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(writer.waitFor()).isNotZero();
    String[] left = folder.toFile().list();
    assertThat(left).as(said).hasSize(1);
    assertThat(said)
        .contains("S-064 cannot write " + folder.resolve("r.csv"))
        .contains("rows so far are in " + folder.resolve(left[0]));
    assertThat(Files.readString(folder.resolve(left[0]))).startsWith("t\r\n0\r\n1\r\n2\r\n");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void takesTheNameOfNoDevice() {
    assertThatThrownBy(() -> new ResultFile(Path.of("/dev/null")))
        .isInstanceOf(IOException.class)
        .hasMessage("S-064 /dev/null is no file; name one for the results");
  }

  @Test
  void namesTheFolderThatIsMissing() {
    assertThatThrownBy(() -> new ResultFile(folder.resolve("none/r.csv")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("none");
  }
}
