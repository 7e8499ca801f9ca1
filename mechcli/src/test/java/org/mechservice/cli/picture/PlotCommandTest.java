package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.result.ResultFormat;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.ResultWriter;

/** {@code mech plot} writes what the name of the output says, and explains what it cannot. */
class PlotCommandTest {
  @TempDir private Path folder;
  private Path result = Path.of("");
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeResult() throws IOException {
    result = Files.writeString(folder.resolve("r.csv"), "t,j.q,j.v\r\n0,1,0\r\n1,2,1\r\n");
  }

  private int plot(String... words) {
    PrintWriter errors = new PrintWriter(err);
    String[] line = new String[words.length + 1];
    line[0] = "plot";
    System.arraycopy(words, 0, line, 1, words.length);
    return Mech.run(new PrintWriter(new StringWriter()), errors, line);
  }

  private String out(String name) {
    return folder.resolve(name).toString();
  }

  @Test
  void endingOfTheNameChoosesTheFormat() throws IOException {
    assertThat(plot(result.toString(), "-o", out("p.svg"))).isEqualTo(ExitStatus.DONE);
    assertThat(plot(result.toString(), "j.*", "-o", out("p.HTML"))).isEqualTo(ExitStatus.DONE);
    assertThat(plot(result.toString(), "--dark", "-o", out("p.png"))).isEqualTo(ExitStatus.DONE);

    assertThat(folder.resolve("p.svg")).content().startsWith("<svg ").contains("j.q");
    assertThat(folder.resolve("p.HTML")).content().startsWith("<!DOCTYPE html>").contains("j.v");
    assertThat(Files.readAllBytes(folder.resolve("p.png"))).startsWith(0x89, 'P', 'N', 'G');
    assertThat(err.toString()).contains("1 of 2 columns");
  }

  /** The picture of the same rows is the same whatever file they are in. */
  @Test
  void resultsOfEveryFormatAreDrawnAlike() throws IOException {
    double[][] rows = {{0, 1, 0}, {1, 2, 1}};
    List<Variable> columns =
        List.of(new Variable("t", "s"), new Variable("j.q", "rad"), new Variable("j.v", "rad/s"));
    Files.writeString(
        folder.resolve("rows.units.json"), "{\"t\":\"s\",\"j.q\":\"rad\",\"j.v\":\"rad/s\"}");
    String first = "";
    for (ResultFormat format : ResultFormat.values()) {
      Path file = folder.resolve("rows." + format.name().toLowerCase(Locale.ROOT));
      try (OutputStream out = Files.newOutputStream(file);
          ResultWriter writer = format.writer(out, file)) {
        writer.begin(columns);
        for (double[] row : rows) {
          writer.row(row);
        }
        writer.finish();
      }
      Path picture = folder.resolve(format.name() + ".svg");
      assertThat(plot(file.toString(), "j.v", "-o", picture.toString()))
          .as("%s: %s", format, err)
          .isEqualTo(ExitStatus.DONE);
      String drawn =
          Files.readString(picture)
              .replace(String.valueOf(file.getFileName()), "rows")
              .replaceAll("title-[0-9a-f]+", "title");
      assertThat(drawn).contains("j.v");
      first = first.isEmpty() ? drawn : first;
      assertThat(drawn).as(format.name()).isEqualTo(first);
    }
  }

  @Test
  void columnsAreSeparatedByCommasOrSpaces() throws IOException {
    assertThat(plot(result.toString(), "j.q,j.v", "-o", out("p.svg"))).isEqualTo(ExitStatus.DONE);

    assertThat(folder.resolve("p.svg")).content().contains(">j.q<", ">j.v<");
  }

  @Test
  void mistakesAreExplainedAndNothingIsWritten() {
    assertThat(plot(result.toString(), "-o", out("p.pdf"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(plot(result.toString(), "k.q", "-o", out("p.svg"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(plot(out("no.csv"), "-o", out("p.svg"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(plot("j.q", "-o", out("p.svg"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(plot(result.toString(), result.toString(), "-o", out("p.svg")))
        .isEqualTo(ExitStatus.BAD_INPUT);

    assertThat(err.toString().lines().toList())
        .hasSize(5)
        .allMatch(line -> line.startsWith("S-04"));
    assertThat(err.toString())
        .contains(".svg, .png, .html", "\"k.q\"", "\"j.q\"", "no.csv", "named twice");
    assertThat(folder.resolve("p.svg")).doesNotExist();
  }
}
