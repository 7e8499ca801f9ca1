package org.mechservice.cli.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.result.ResultFormat;
import org.mechservice.result.SignalTable;

@Tag("slow")
class SimulateOutputTest {
  private static final String MODEL = "../examples/pendulum/pendulum.xml";

  @TempDir private Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int simulate(String... options) {
    List<String> words = new ArrayList<>(List.of("simulate", MODEL));
    words.addAll(List.of(options));
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words.toArray(String[]::new));
  }

  private Path file(ResultFormat format) {
    return folder.resolve("r" + format.ending());
  }

  @ParameterizedTest
  @ValueSource(strings = {"remote", "local"})
  void oneRunWritesTheSameNumbersInEveryFormat(String mode) throws IOException {
    List<String> options = new ArrayList<>(List.of("--mode", mode, "--columns", "energy"));
    for (ResultFormat format : ResultFormat.values()) {
      options.addAll(List.of("--out", file(format).toString()));
    }
    assertThat(simulate(options.toArray(String[]::new))).as(err.toString()).isZero();

    SignalTable csv = SignalTable.read(file(ResultFormat.CSV));
    assertThat(csv.columns()).anyMatch(column -> column.unit().equals("J"));
    for (ResultFormat format : ResultFormat.values()) {
      SignalTable table = SignalTable.read(file(format));
      assertThat(table.columns()).isEqualTo(csv.columns());
      assertThat(table.values().toArray(double[][]::new))
          .as(format.name())
          .isDeepEqualTo(csv.values().toArray(double[][]::new));
    }
  }

  @Test
  void animatedSceneAloneAsksForThePlacesOfTheBodies() throws IOException {
    Path scene = folder.resolve("r.glb");

    assertThat(simulate("--out", scene.toString())).as(err.toString()).isZero();

    assertThat(Files.readAllBytes(scene)).startsWith('g', 'l', 'T', 'F');
  }

  @Test
  void animatedSceneBesideATableIsThatOfTheView() throws IOException {
    Path scene = folder.resolve("r.glb");
    Path viewed = folder.resolve("v.glb");
    String table = file(ResultFormat.CSV).toString();

    assertThat(simulate("--out", table, "--out", scene.toString(), "--columns", "energy")).isZero();
    assertThat(Files.readString(Path.of(table)).lines().findFirst().orElseThrow())
        .contains("energy.kinetic", "bar1.x");
    Mech.run(new PrintWriter(out), new PrintWriter(err), "view", MODEL, "-o", viewed.toString());
    assertThat(scene).hasSameBinaryContentAs(viewed);
    assertThat(Path.of(table)).exists();
  }

  @Test
  void dashPrintsTheRowsAndNothingElse() throws IOException {
    assertThat(simulate("--out", "-", "--out", file(ResultFormat.CSV).toString())).isZero();

    assertThat(out.toString()).isEqualTo(Files.readString(file(ResultFormat.CSV)));
    assertThat(err.toString()).contains("outcome");
  }

  @Test
  void dashAndTheReportAsJsonDoNotShareStandardOutput() {
    assertThat(simulate("--out", "-", "--json")).isEqualTo(ExitStatus.BAD_INPUT);

    assertThat(err.toString()).startsWith("S-041 --json and --out -");
    assertThat(out.toString()).isEmpty();
  }

  /**
   * It is told at once, not after the set-up: the model, which does not exist, is not asked for.
   */
  @Test
  void aFolderThatDoesNotExistIsToldBeforeTheModelIsRead() {
    Path results = folder.resolve("none").resolve("r.csv");
    int status =
        Mech.run(
            new PrintWriter(out),
            new PrintWriter(err),
            "simulate",
            folder.resolve("none.xml").toString(),
            "--out",
            results.toString());

    assertThat(status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .startsWith("S-044 --out " + results)
        .contains("the folder " + folder.resolve("none") + " does not exist");
  }

  @ParameterizedTest
  @ValueSource(strings = {"r.xlsx", "r", "r.csv.gz"})
  void unknownEndingIsRefusedWithTheKnownOnes(String name) {
    assertThat(simulate("--out", folder.resolve(name).toString())).isEqualTo(ExitStatus.BAD_INPUT);

    assertThat(err.toString())
        .startsWith("S-044 --out " + folder.resolve(name))
        .contains(".csv, .tsv, .mat, .json, .parquet");
  }

  @ParameterizedTest
  @ValueSource(strings = {"remote", "local"})
  void runThatAMatFileCannotHoldIsRefusedBeforeItStarts(String mode) {
    int status =
        simulate("--mode", mode, "--t-step", "1e-8", "--out", file(ResultFormat.MAT).toString());

    assertThat(status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-176 --out " + file(ResultFormat.MAT));
    assertThat(folder).isEmptyDirectory();
  }

  @ParameterizedTest
  @ValueSource(strings = {".csv", ".tsv", ".mat", ".json", ".parquet"})
  void failedRunLeavesItsRowsInEveryFormat(String ending) throws IOException {
    Path file = folder.resolve("r" + ending);
    int status = simulate("--max-drift", "1e-14", "--columns", "energy", "--out", file.toString());

    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.SIMULATION_FAILED);
    assertThat(err.toString()).contains("Rows up to there are in " + file);
    assertThat(SignalTable.read(file).rows()).isPositive();
  }
}
