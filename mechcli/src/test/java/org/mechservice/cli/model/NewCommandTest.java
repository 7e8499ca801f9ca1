package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

class NewCommandTest {
  @TempDir private Path folder = Path.of("");

  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    return Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err), words);
  }

  @Test
  void modelRunsAndConservesWhatItsDamperDoesNotTake() throws Exception {
    Path rows = folder.resolve("r.csv");
    assertThat(mech("new", folder.resolve("arm").toString())).isEqualTo(ExitStatus.DONE);
    String model = folder.resolve("arm.xml").toString();
    assertThat(mech("simulate", model, "--max-drift", "1e-4", "--out", rows.toString(), "--quiet"))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(Files.readAllLines(rows)).hasSize(502);
  }

  @Test
  void modelIsNotWrittenOverAnother() throws Exception {
    Path file = folder.resolve("arm.xml");
    Files.writeString(file, "mine");
    assertThat(mech("new", file.toString())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-046").contains("exists");
    assertThat(file).hasContent("mine");
  }

  @Test
  void nameThatNoExpressionCouldUseIsRefused() {
    assertThat(mech("new", folder.resolve("3 arms").toString())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041").contains("\"3 arms\"");
    assertThat(folder).isEmptyDirectory();
  }
}
