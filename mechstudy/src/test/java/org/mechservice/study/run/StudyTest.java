package org.mechservice.study.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.study.PointOutcome;
import org.mechservice.study.StudyModels;

/** Studies: the same bytes whatever happens on the way. */
class StudyTest {
  private static final String POINTS =
      "<factor name='k' distribution='uniform' from='10' to='40'/>"
          + "<factor name='m' values='1 2 3 -1'/><design kind='monte-carlo' points='60' seed='4'/>"
          + "<output name='end' of='last(x.q)' unit='mm' failing='5'/>"
          + "<output of='series(x.q,0.5)'/>";

  @TempDir private Path folder;
  private int files;

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(folder.resolve("spring.xml"), StudyModels.SPRING);
  }

  private StudyPlan plan(String content) throws IOException, MechmlException {
    Path file = folder.resolve("study.xml");
    Files.writeString(file, "<study model='spring.xml'>\n" + content + "\n</study>\n");
    return StudyReader.read(file);
  }

  private Path run(StudyPlan plan, StudyPart part, int threads) throws Exception {
    Path out = folder.resolve("out" + files++ + ".csv");
    new Study(plan, part, plan.model()).run(out, threads, (done, before, all) -> {});
    return out;
  }

  private static void assertSame(Path a, Path b) throws IOException {
    assertThat(Files.readString(a)).isEqualTo(Files.readString(b));
    assertThat(Files.readString(StudyTable.beside(a)))
        .isEqualTo(Files.readString(StudyTable.beside(b)));
  }

  @Test
  void tableHasARowForEachPointAndSaysWhyOneFailed() throws Exception {
    List<String> lines = Files.readAllLines(run(plan(POINTS), StudyPart.WHOLE, 2));

    assertThat(lines).hasSize(61);
    assertThat(lines.get(0)).isEqualTo("point,k,m,outcome,code,message,end,x.q@0,x.q@0.5,x.q@1");
    for (String line : lines.subList(1, 61)) {
      List<String> cells = CsvLine.cells(line);
      boolean failed = cells.get(2).equals("-1");
      assertThat(cells.get(3)).isEqualTo(failed ? "failed" : "completed");
      assertThat(cells.get(4)).isEqualTo(failed ? "M-030" : "");
      assertThat(cells.get(5).isEmpty()).isEqualTo(!failed);
      if (!failed) {
        double w = Math.sqrt(Double.parseDouble(cells.get(1)) / Double.parseDouble(cells.get(2)));
        assertThat(Double.parseDouble(cells.get(6))).isCloseTo(100 * Math.cos(w), within(1e-5));
      }
    }
  }

  @Test
  void bytesDoNotDependOnThreads() throws Exception {
    StudyPlan plan = plan(POINTS);

    assertSame(run(plan, StudyPart.WHOLE, 1), run(plan, StudyPart.WHOLE, 5));
  }

  @Test
  void joinedPartsAreTheWholeByteByByte() throws Exception {
    StudyPlan plan = plan(POINTS);
    List<Path> parts = new ArrayList<>();
    for (int i = 7; i >= 1; i--) {
      parts.add(run(plan, new StudyPart(i, 7), 2));
    }
    Path all = folder.resolve("all.csv");
    StudyJoin.join(parts, all);

    assertSame(all, run(plan, StudyPart.WHOLE, 2));
    assertThatThrownBy(() -> StudyJoin.join(parts.subList(0, 6), all))
        .hasMessageContaining("S-182 part 1/7 is missing");
    assertThatThrownBy(() -> StudyJoin.join(List.of(parts.get(0), parts.get(0)), all))
        .hasMessageContaining("are both part 7/7");
    Path other = run(plan(POINTS.replace("seed='4'", "seed='5'")), new StudyPart(1, 7), 2);
    assertThatThrownBy(() -> StudyJoin.join(List.of(parts.get(0), other), all))
        .hasMessageContaining("is of another study");
    Path cut = parts.get(3);
    List<String> lines = Files.readAllLines(cut);
    Files.write(cut, lines.subList(0, lines.size() - 2));
    assertThatThrownBy(() -> StudyJoin.join(parts, all))
        .hasMessageContaining("run this part again");
  }

  /** The process ends after a number of points; of the last line a part may be written. */
  @ParameterizedTest
  @CsvSource({"1, 0", "17, 3", "40, 20", "59, 1", "60, 0"})
  void killedStudyGoesOnToTheSameBytes(int points, int lostBytes) throws Exception {
    StudyPlan plan = plan(POINTS);
    Path out = folder.resolve("killed.csv");
    AtomicInteger begun = new AtomicInteger();
    Study killed =
        new Study(
            plan,
            StudyPart.WHOLE,
            values -> {
              if (begun.incrementAndGet() > points) {
                throw new IOException("killed");
              }
              return plan.model().run(values);
            });
    if (points < 60) {
      assertThatThrownBy(() -> killed.run(out, 2, (done, before, all) -> {})).hasMessage("killed");
      Path journal = folder.resolve("killed.csv.unfinished");
      assertThat(journal).exists();
      assertThat(out).doesNotExist();
      try (FileChannel channel = FileChannel.open(journal, StandardOpenOption.WRITE)) {
        channel.truncate(channel.size() - lostBytes);
      }
    }
    Study again = new Study(plan, StudyPart.WHOLE, plan.model());
    again.run(out, 2, (done, before, all) -> {});

    assertSame(out, run(plan, StudyPart.WHOLE, 1));
    assertThat(folder.resolve("killed.csv.unfinished")).doesNotExist();
  }

  @Test
  void fullDiskIsSaidOfItsFile() throws Exception {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "there is no /dev/full to write to");
    Path journal = folder.resolve("full.csv.unfinished");
    Files.createSymbolicLink(journal, full);
    StudyPlan plan = plan(POINTS);

    assertThatThrownBy(
            () ->
                new Study(plan, StudyPart.WHOLE, plan.model())
                    .run(folder.resolve("full.csv"), 1, (done, before, all) -> {}))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("S-042 " + journal + " cannot be written: No space left");
  }

  @Test
  void journalOfAnotherStudyIsRefused() throws Exception {
    Path out = folder.resolve("a.csv");
    Files.writeString(folder.resolve("a.csv.unfinished"), "{\"other\":1}\n");
    StudyPlan plan = plan(POINTS);

    assertThatThrownBy(
            () ->
                new Study(plan, StudyPart.WHOLE, plan.model())
                    .run(out, 1, (done, before, all) -> {}))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("S-181");
  }

  @ParameterizedTest
  @ValueSource(strings = {"<stop failures='3'/>", "<stop output='end' error='9'/>"})
  void stopRuleEndsTheStudyAtTheSamePointOnAnyWay(String stop) throws Exception {
    StudyPlan plan = plan(POINTS + stop);
    Path whole = run(plan, StudyPart.WHOLE, 1);
    Path all = folder.resolve("joined.csv");
    StudyJoin.join(
        List.of(run(plan, new StudyPart(1, 2), 2), run(plan, new StudyPart(2, 2), 2)), all);

    assertThat(Files.readAllLines(whole).size()).isBetween(4, 60);
    assertSame(whole, run(plan, StudyPart.WHOLE, 4));
    assertSame(whole, all);
  }

  @Test
  void failingPointWeighsWhatItsOutputSays() throws Exception {
    StudyPlan plan = plan(POINTS);
    StudyStatistics statistics = new StudyStatistics(plan.outputs());
    StudyTable table = new StudyTable(2, plan.outputs().size());
    table.addTo(
        statistics,
        plan.row(0, new PointOutcome.Failed("N-001", "why, \"so\"", 0.5)).stripTrailing());
    table.addTo(
        statistics, plan.row(1, new PointOutcome.Values(new double[] {0.001, 0.1, 2, 3})).strip());

    assertThat(statistics.failed()).isEqualTo(1);
    assertThat(statistics.mean(0)).isEqualTo(3); // 5 mm and 1 mm
    assertThat(statistics.count(1)).isEqualTo(1);
  }

  /** Robust design by Monte Carlo: masses below 0 cannot run, and are neither lost nor silent. */
  @Test
  void failingPointsOfMonteCarloAreCountedAndWeighedAsTheUserSays() throws Exception {
    Path out =
        run(
            plan(
                "<factor name='m' distribution='normal' mean='1' deviation='1'/>"
                    + "<design kind='monte-carlo' points='200' seed='3'/>"
                    + "<output name='weighed' of='last(x.q)' failing='7'/>"
                    + "<output name='left out' of='last(x.v)'/>"),
            StudyPart.WHOLE,
            2);
    double weighed = 0;
    double leftOut = 0;
    int failed = 0;
    for (String line : Files.readAllLines(out).subList(1, 201)) {
      List<String> cells = CsvLine.cells(line);
      boolean below = Double.parseDouble(cells.get(1)) < 0;
      assertThat(cells.get(2)).isEqualTo(below ? "failed" : "completed");
      assertThat(cells.get(3)).isEqualTo(below ? "M-030" : "");
      failed += below ? 1 : 0;
      weighed += below ? 7 : Double.parseDouble(cells.get(5));
      leftOut += below ? 0 : Double.parseDouble(cells.get(6));
    }
    JsonObject told =
        JsonParser.parseString(Files.readString(StudyTable.beside(out))).getAsJsonObject();
    JsonArray statistics = told.getAsJsonArray("statistics");

    assertThat(failed).isBetween(10, 60); // 32 are expected
    assertThat(told.get("failed").getAsInt()).isEqualTo(failed);
    assertThat(mean(statistics, 0)).isCloseTo(weighed / 200, within(1e-12));
    assertThat(mean(statistics, 1)).isCloseTo(leftOut / (200 - failed), within(1e-12));
  }

  private static double mean(JsonArray statistics, int output) {
    return statistics.get(output).getAsJsonObject().get("mean").getAsDouble();
  }

  @Test
  void unitsOfFactorsAreConverted() throws Exception {
    Path inNewtonPerMillimetre =
        run(
            plan("<factor name='k' unit='N/mm' values='0.02 0.05'/><output of='last(x.q)'/>"),
            StudyPart.WHOLE,
            1);
    Path inModel =
        run(plan("<factor name='k' values='20 50'/><output of='last(x.q)'/>"), StudyPart.WHOLE, 1);

    assertThat(lastCells(inNewtonPerMillimetre)).isEqualTo(lastCells(inModel));
  }

  private static List<String> lastCells(Path table) throws IOException {
    return Files.readAllLines(table).stream()
        .skip(1)
        .map(line -> line.substring(line.lastIndexOf(',')))
        .toList();
  }

  @Test
  void runsAreAsTheStudySaysAndEachColumnMayBeKept() throws Exception {
    List<String> lines =
        Files.readAllLines(
            run(
                plan(
                    "<run t-end='0.5' rtol='1e-10' atol='1e-12' integrator='ode113'"
                        + " columns='energy'/><factor name='k' values='20'/>"
                        + "<output name='*' of='last(*)'/><output of='min(*)'/>"),
                StudyPart.WHOLE,
                1));

    assertThat(lines.get(0))
        .startsWith("point,k,outcome,code,message,x.q,x.v,energy.")
        .contains(",min(x.q),min(x.v),");
    double w = Math.sqrt(10); // 20 N/m, 2 kg
    assertThat(Double.parseDouble(lines.get(1).split(",", -1)[5]))
        .isCloseTo(0.1 * Math.cos(0.5 * w), within(1e-10));
  }

  @Test
  void tableOfPointsIsTakenAsItIs() throws Exception {
    Files.writeString(folder.resolve("points.csv"), "m,k\n1,20\n2,50\n");
    List<String> lines =
        Files.readAllLines(
            run(plan("<table file='points.csv'/><output of='last(x.q)'/>"), StudyPart.WHOLE, 1));

    assertThat(lines).hasSize(3);
    assertThat(lines.get(2)).startsWith("2,2,50,completed");
  }

  @Test
  void valuesAreNumbersOrConstantExpressionsOfTheLanguage() throws Exception {
    List<String> lines =
        Files.readAllLines(
            run(
                plan(
                    "<factor name='k' from='2*10' to='5^2' count='2'/>"
                        + "<factor name='m' values='PI/4, max(1, sqrt(4)); 3'/>"
                        + "<output of='last(x.q)'/>"),
                StudyPart.WHOLE,
                1));
    String quarter = Double.toString(Math.PI / 4);
    assertThat(lines.stream().skip(1).map(line -> CsvLine.cells(line).subList(1, 3)))
        .containsExactly(
            List.of("20", quarter),
            List.of("20", "2"),
            List.of("20", "3"),
            List.of("25", quarter),
            List.of("25", "2"),
            List.of("25", "3"));

    Files.writeString(folder.resolve("points.csv"), "m,k\n1,20\nPI/4,\"max(30,5^2)\"\n");
    List<String> points =
        Files.readAllLines(
            run(plan("<table file='points.csv'/><output of='last(x.q)'/>"), StudyPart.WHOLE, 1));
    assertThat(points.get(2)).startsWith("2," + quarter + ",30,completed");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "<factor name='k' values='1 pi/4'/>; \"pi/4\" is no number and no constant expression:"
            + " \"pi\" is not a known name here; did you mean \"PI\"?",
        "<factor name='k' from='1/0' to='2' count='3'/>; from \"1/0\" is no number and no constant"
            + " expression: division by zero",
        "<factor name='kk' values='1'/>; no parameter \"kk\"; did you mean \"k\"?",
        "<factor name='k' unit='kg' values='1'/>; one of a mass",
        "<factor name='k'/>; it has no values",
        "<factor name='k' values='1 two'/>; \"two\" is no number",
        "<factor name='k' distribution='norml' mean='1'/>; did you mean \"normal\"?",
        "<factor name='k' distribution='normal' mean='1' deviation='-1'/>; not possible",
        "<factor name='k' from='1' to='2'/>; needs count",
        "<factor name='k' valeus='1'/>; did you mean \"values\"?",
        "<factr name='k'/>; did you mean \"factor\"?",
        "<design kind='sobel' points='3'/>; did you mean \"sobol\"?",
        "<design kind='sobol'/>; it lacks points",
        "<output of='largest(x.q)'/>; no reduction \"largest\"",
        "<output of='max(x.p)'/>; did you mean \"x.q\"?",
        "<output of='max(x.q)' unit='s'/>; one of a time",
        "<stop output='x' error='1'/>; no output \"x\"",
        "<table file='none.csv'/>; cannot be read",
        "<factor name='k' unit='N/mx' values='1'/>; unit",
        "<output of='max(x.q)' unit='parsec'/>; unit",
        "<run rtol='2'/>; rtol is 2.0; it must be below 1",
        "<run atol='-1'/>; atol is -1; it must be above 0",
        "<run t-end='-1'/>; before the start of the run",
        "<run t-step='0'/>; t-step is 0; it must be above 0",
        "<run integrator='ode16'/>; S-082 integrator \"ode16\"",
        "<run columns='reaction'/>; did you mean \"reactions\"?",
        "<run tend='1'/>; did you mean \"t-end\"?",
      })
  void badInputSaysWhereAndWhatToWrite(String element, String why) {
    String rest =
        (element.contains("'k'") || element.contains("table")
                ? ""
                : "<factor name='k' values='1'/>")
            + (element.contains("<output") ? "" : "<output of='last(x.q)'/>");

    assertThatThrownBy(() -> plan(element + "\n" + rest))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("study.xml:2:")
        .hasMessageContaining("S-180")
        .hasMessageContaining(why);
  }

  private static final String YAML =
      """
      # the study POINTS
      model: spring.xml
      factors:
        - {name: k, distribution: uniform, from: 10, to: 40}
        - name: m
          values: [1, 2, 3, -1]
      design: {kind: monte-carlo, points: 60, seed: 4}
      outputs:
        - {name: end, of: last(x.q), unit: mm, failing: 5}
        - of: series(x.q,0.5)
      """;

  @Test
  void studyInYamlHasTheTableOfTheSameInXml() throws Exception {
    Path file = folder.resolve("study.yaml");
    Files.writeString(file, YAML);
    Path table = run(StudyReader.read(file), StudyPart.WHOLE, 2);

    assertThat(Files.readString(table))
        .isEqualTo(Files.readString(run(plan(POINTS), StudyPart.WHOLE, 2)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "name: k, distribution: u; name: kk, distribution: u; study.yaml:4:; did you mean \"k\"?",
        "- name: m; - nmae: m; study.yaml:5:; did you mean \"name\"?",
        "design: {; desing: {; study.yaml:7:; did you mean \"design\"?",
        "[1, 2, 3, -1]; [1, [2]]; study.yaml:6:; list in a list",
        "[1, 2, 3, -1]; [1, 2; study.yaml:7:; this is no YAML",
        "to: 40; from: 40; study.yaml:4:; from is given twice",
        "- of: series(x.q,0.5); - series(x.q,0.5); study.yaml:10:; {of: max(height.q)}",
      })
  void badYamlSaysWhereAndWhatToWrite(String good, String bad, String where, String why)
      throws IOException {
    Path file = folder.resolve("study.yaml");
    Files.writeString(file, YAML.replace(good, bad));

    assertThatThrownBy(() -> StudyReader.read(file))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(where)
        .hasMessageContaining("S-180")
        .hasMessageContaining(why);
  }

  /** Arrow and DuckDB find the cells of the CSV table; an empty cell of a number is NaN. */
  @Test
  void parquetTableHasTheCellsOfTheCsvTable() throws Exception {
    String python = System.getenv().getOrDefault("MECH_PYTHON", "python3");
    assumeTrue(
        new ProcessBuilder(python, "-c", "import pandas, pyarrow, duckdb").start().waitFor() == 0,
        python + " has no pandas, pyarrow or duckdb");
    StudyPlan plan = plan(POINTS);
    Path csv = run(plan, StudyPart.WHOLE, 2);
    Path parquet = folder.resolve("table.parquet");
    new Study(plan, StudyPart.WHOLE, plan.model()).run(parquet, 2, (done, before, all) -> {});
    String program =
        """
        import sys, json, pandas, duckdb, pyarrow.parquet as pq
        texts = {"code": str, "message": str}
        csv = pandas.read_csv(sys.argv[1], dtype=texts, float_precision="round_trip")
        csv = csv.fillna({"code": "", "message": ""}).astype({"point": float, "m": float})
        table = pq.read_table(sys.argv[2])
        pandas.testing.assert_frame_equal(csv, table.to_pandas(), check_exact=True)
        same = duckdb.sql(f"select * from '{sys.argv[2]}'").df()
        pandas.testing.assert_frame_equal(csv, same, check_exact=True)
        study = json.loads(table.schema.metadata[b"study"])
        print(study["rows"], study["identity"]["design"][0]["kind"])
        """;
    Process process =
        new ProcessBuilder(
                python, "-W", "ignore", "-c", program, csv.toString(), parquet.toString())
            .redirectErrorStream(true)
            .start();

    assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
        .isEqualTo("60 monte-carlo\n");
    assertThat(Files.readString(StudyTable.beside(parquet)))
        .isEqualTo(Files.readString(StudyTable.beside(csv)));
  }
}
