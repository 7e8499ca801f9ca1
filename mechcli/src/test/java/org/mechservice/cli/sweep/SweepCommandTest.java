package org.mechservice.cli.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;

/**
 * A seat, its damper and its spring, at a server that runs nothing itself and has three hosts with
 * four places.
 */
@Tag("slow")
class SweepCommandTest {
  private static final Path SEAT = Path.of("../examples/sweep/seat.xml");

  private static MechServerProcess server;
  private static final List<SimHostProcess> HOSTS = new ArrayList<>();

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeAll
  static void start() {
    server = MechServerProcess.start(new ServerSettings("lab", "127.0.0.1", 0, 0));
    for (int capacity : new int[] {1, 1, 2}) {
      HOSTS.add(host("h" + HOSTS.size(), capacity));
    }
  }

  private static SimHostProcess host(String name, int capacity) {
    return SimHostProcess.start(new HostSettings(server.url(), name, "127.0.0.1", 0, capacity));
  }

  @AfterAll
  static void stop() {
    HOSTS.forEach(SimHostProcess::close);
    server.close();
  }

  private int mech(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private int sweep(Path model, String... more) {
    List<String> words =
        new ArrayList<>(List.of("sweep", model.toString(), "--server", server.url(), "--quiet"));
    words.addAll(List.of(more));
    return mech(words.toArray(String[]::new));
  }

  private static List<List<String>> cells(String csv) {
    return csv.lines().map(line -> Arrays.asList(line.split(",", -1))).toList();
  }

  private List<String> lastRowOfOneRun(String... options) throws IOException {
    Path file = folder.resolve("one.csv");
    List<String> words =
        new ArrayList<>(List.of("simulate", SEAT.toString(), "--quiet", "--out", file.toString()));
    words.addAll(List.of(options));
    assertThat(mech(words.toArray(String[]::new))).as(err.toString()).isZero();
    List<String> rows = Files.readAllLines(file);
    return Arrays.asList(rows.get(rows.size() - 1).split(",", -1));
  }

  @Test
  void everyRowReadsAsThatOfTheSameRunMadeAlone() throws Exception {
    assertThat(sweep(SEAT, "--set", "damping=500:4500:3", "--set", "stiffness=20000,3.1e4"))
        .as(err.toString())
        .isZero();
    List<List<String>> rows = cells(out.toString());
    assertThat(rows.get(0))
        .containsExactly(
            "point",
            "damping",
            "stiffness",
            "outcome",
            "code",
            "message",
            "height.q",
            "height.v",
            "energy left");
    assertThat(rows).hasSize(7);
    assertThat(rows.stream().skip(1).map(row -> row.get(1) + " " + row.get(2)))
        .startsWith("500 20000", "500 31000", "2500 20000");
    for (List<String> row : rows.subList(1, 7)) {
      assertThat(row.get(3)).isEqualTo("completed");
      List<String> alone =
          lastRowOfOneRun("--set", "damping=" + row.get(1), "--set", "stiffness=" + row.get(2));
      assertThat(row.subList(6, 9)).isEqualTo(alone.subList(1, 4));
    }
    assertThat(err.toString()).isEmpty();
  }

  /** On threads, on hosts, and by a study file: rows with a method of their own, and one fails. */
  @Test
  void sweepIsTheStudyOfItsGridOnEveryEngine() throws Exception {
    String[] grid = {
      "sweep",
      SEAT.toString(),
      "--set",
      "damping=500,-1e300,900",
      "--set",
      "stiffness=18000:22000:3",
      "--take",
      "energy left,series(height.q, 0.5),max(height.a)",
      "--integrator",
      "DE",
      "--rtol",
      "1e-5",
      "--t-end",
      "1.5",
    };
    Path here = folder.resolve("here.csv");
    Path there = folder.resolve("there.csv");
    Path study = folder.resolve("study.xml");
    Path ofStudy = folder.resolve("of-study.csv");

    assertThat(mech(with(grid, "-o", here.toString()))).as(err.toString()).isZero();
    assertThat(out.toString()).contains("here.csv: 9 points; 3 failed: their rows say why");
    assertThat(mech(with(grid, "-o", there.toString(), "--server", server.url())))
        .as(err.toString())
        .isZero();
    assertThat(mech(with(grid, "--study", study.toString()))).as(err.toString()).isZero();
    assertThat(mech("study", study.toString(), "-o", ofStudy.toString()))
        .as(err.toString())
        .isZero();

    assertThat(Files.readString(here))
        .startsWith(
            "point,damping,stiffness,outcome,code,message,energy left,height.q@0,height.q@0.5,"
                + "height.q@1,height.q@1.5,max(height.a)\n1,500,18000,completed,,,")
        .contains("4,-1e300,18000,failed,N-");
    assertThat(there).hasSameBinaryContentAs(here);
    assertThat(folder.resolve("there.study.json"))
        .hasSameBinaryContentAs(folder.resolve("here.study.json"));
    assertThat(ofStudy).hasSameBinaryContentAs(here);
    assertThat(mech(grid)).isZero();
    assertThat(out.toString()).isEqualTo(Files.readString(here));
    assertThat(err.toString()).isEqualTo("9 points; 3 failed: their rows say why\n");
  }

  private static String[] with(String[] words, String... more) {
    return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray(String[]::new);
  }

  @Test
  void killedSweepGoesOnWhereItWasAndEndsWithTheSameBytes() throws Exception {
    String set = "damping=100:5000:100";
    Path whole = folder.resolve("whole.csv");
    assertThat(sweep(SEAT, "--set", set, "-o", whole.toString())).isZero();
    Path parts = folder.resolve("parts.csv");
    Path journal = folder.resolve("parts.csv.unfinished");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Mech.class.getName(),
                "sweep",
                SEAT.toString(),
                "--server",
                server.url(),
                "--threads",
                "1",
                "--set",
                set,
                "-o",
                parts.toString())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      Eventually.holds(() -> Files.exists(journal) && Files.readAllLines(journal).size() > 3);
    } finally {
      process.destroyForcibly().waitFor();
    }
    assertThat(parts).doesNotExist();
    // It was killed while it wrote the next line.
    Files.writeString(journal, "99,4", StandardOpenOption.APPEND);

    assertThat(mech("sweep", SEAT.toString(), "--set", set, "-o", parts.toString())).isZero();
    assertThat(out.toString()).containsPattern("100 points, [0-9]+ of them finished before");
    assertThat(journal).doesNotExist();
    assertThat(parts).hasSameBinaryContentAs(whole);
  }

  @Test
  void pointsOfAnotherSweepAreNotTakenOver() throws Exception {
    Path file = folder.resolve("parts.csv");
    Path journal = folder.resolve("parts.csv.unfinished");
    String left = "{\"study\":\"other.xml\"}\n1,500\n";
    Files.writeString(journal, left);
    assertThat(sweep(SEAT, "--set", "damping=500:4500:5", "-o", file.toString())).isNotZero();
    assertThat(err.toString()).startsWith("S-181 ").contains("parts.csv.unfinished");
    assertThat(file).doesNotExist();
    assertThat(journal).hasContent(left);
  }

  @Test
  void sweepThatIsRefusedAtOnceStandsInNoOnesWay() throws Exception {
    Path file = folder.resolve("parts.csv");
    assertThat(sweep(SEAT, "--set", "colour=1:2:2", "-o", file.toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(folder.resolve("parts.csv.unfinished")).doesNotExist();
    assertThat(sweep(SEAT, "--set", "damping=500,4500", "-o", file.toString())).isZero();
  }

  @Test
  void valuesMayBeConstantExpressions() throws Exception {
    assertThat(
            sweep(
                SEAT,
                "--set",
                "damping=1000*sin(PI/2)-500:9*500:3",
                "--set",
                "stiffness=2e4, max(3.1e4, 5 ^ 2)"))
        .as(err.toString())
        .isZero();
    assertThat(cells(out.toString()).stream().skip(1).map(row -> row.get(1) + " " + row.get(2)))
        .containsExactly(
            "500 20000", "500 31000", "2500 20000", "2500 31000", "4500 20000", "4500 31000");
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "damping=1,pi | S-041 --set damping=1,pi: \"pi\" is no number and no constant expression:"
            + " \"pi\" is not a known name here; did you mean \"PI\"?; write NAME=",
        "damping=1,2 3 | S-041 --set damping=1,2 3: \"2 3\" is no number and no constant",
        "damping=1:2 | S-041 --set damping=1:2: a range has three parts, not 2; write NAME=",
        "damping=1:2:x | S-041 --set damping=1:2:x: \"x\" is no whole number of values",
        "damping=1:2:1 | S-041 --set damping=1:2:1: a range has 2 values or more, not 1",
        "damping=a:2:3 | S-041 --set damping=a:2:3: \"a\" is no number",
        "damping=0:1e999:3 | S-041 --set damping=0:1e999:3: \"1e999\" is not finite",
        "damping | S-041 --set damping: it names no parameter",
        "damping= | S-041 --set damping=: it has no value",
        "damping=1,,2 | S-041 --set damping=1,,2: a value between commas is missing",
        "nosuch=1,2 | S-180 factor \"nosuch\": the model has no parameter \"nosuch\"",
      })
  @ParameterizedTest
  void whatCannotBeSweptIsSaidInOneLine(String set, String message) {
    assertThat(sweep(SEAT, "--set", set)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith(message).hasLineCount(1);
    assertThat(out.toString()).isEmpty();
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "--take | x | S-180 the model has no column \"x\"",
        "--take | largest(height.q) | S-180 of=\"largest(height.q)\": there is no reduction",
        "--set | damping=1 | S-041 --set names parameter \"damping\" twice",
        "--rtol | 3 | S-180 run: rtol is 3.0; it must be below 1",
        "--atol | 1e-6;1 | S-180 run: atol is \"1e-6;1\"; it takes one number, or four",
        "--t-step | -1 | S-180 run: t-step is -1.0; it must be above 0",
        "--t-end | -1 | S-180 run: t-end is -1.0 s, before the start of the run at 0.0 s",
        "--integrator | ode16 | S-180 run: S-082 integrator \"ode16\"",
        "--accuracy | high | S-180 run: ",
        "--threads | 0 | S-041 --threads is 0; it must be 1 or more",
        "-o | t.txt | S-044 -o t.txt: the table of a study is written to a .csv or a .parquet file",
      })
  @ParameterizedTest
  void optionsThatDoNotFitAreNamed(String option, String value, String message) {
    assertThat(sweep(SEAT, "--set", "damping=1,2", option, value)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith(message).hasLineCount(1);
  }

  @Test
  void lostServerLeavesWhatIsFinished() throws Exception {
    MechServerProcess doomed =
        MechServerProcess.start(new ServerSettings("doomed", "127.0.0.1", 0, 1));
    Path journal = folder.resolve("r.csv.unfinished");
    FutureTask<Boolean> loss =
        new FutureTask<>(
            () -> {
              Eventually.holds(
                  () -> Files.exists(journal) && Files.readAllLines(journal).size() > 3);
              doomed.close();
              return true;
            });
    new Thread(loss).start();
    int status =
        mech(
            "sweep",
            SEAT.toString(),
            "--quiet",
            "--server",
            doomed.url(),
            "--set",
            "damping=100:5000:40000",
            "-o",
            folder.resolve("r.csv").toString());
    assertThat(loss.get()).isTrue();
    assertThat(status).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).contains("; finished rows are kept, and the same command goes on");
    assertThat(folder.resolve("r.csv")).doesNotExist();
    assertThat(Files.readAllLines(journal)).hasSizeGreaterThan(3);
  }

  /** A settled mass, an input of the code, and points that cannot be read or cannot go on. */
  @Test
  void studyOnHostsHasTheBytesOfThreadsAlsoWhereAHostIsLost() throws Exception {
    Files.copy(SEAT, folder.resolve("seat.xml"));
    Path study =
        Files.writeString(
            folder.resolve("study.xml"),
            """
            <study model='seat.xml'>
              <factor name='damping' values='500 -1e30 900 1300'/>
              <factor name='stiffness' from='18000' to='22000' count='10'/>
              <output of='min(height.q)' unit='mm'/>
              <output of='series(height.q, 0.5)'/>
            </study>
            """);
    Path here = folder.resolve("here.csv");
    assertThat(mech("study", study.toString(), "-o", here.toString())).isZero();
    SimHostProcess lost = host("lost", 2);
    Path there = folder.resolve("there.csv");
    FutureTask<Boolean> loss =
        new FutureTask<>(
            () -> {
              Path journal = folder.resolve("there.csv.unfinished");
              Eventually.holds(() -> Files.exists(journal) || Files.exists(there));
              lost.close();
              return true;
            });
    new Thread(loss).start();
    int status =
        mech(
            "study",
            study.toString(),
            "--engine",
            "hosts",
            "--server",
            server.url(),
            "-o",
            there.toString());
    assertThat(loss.get()).isTrue();

    assertThat(status).as(err.toString()).isZero();
    assertThat(there).hasSameBinaryContentAs(here);
    assertThat(folder.resolve("there.study.json"))
        .hasSameBinaryContentAs(folder.resolve("here.study.json"));
    assertThat(Files.readString(here)).contains(",failed,");
  }

  @Test
  void studyRefusesOptionsOfAnotherEngine() {
    assertThat(mech("study", "s.xml", "--server", server.url())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-041", "--server is none of --engine threads");
  }

  @Test
  void studyOnSparkNeedsSpark() {
    assertThatThrownBy(
            () ->
                SparkSubmit.command(
                    Map.of("PATH", folder.toString()), Optional.empty(), List.of(), List.of()))
        .hasMessageContaining("S-183");
  }

  @Test
  void sparkSubmitGetsTheJarsThatExecutorsNeed() throws IOException {
    Path submit = Files.createFile(folder.resolve("spark-submit"));
    assertThat(submit.toFile().setExecutable(true)).isTrue();
    Optional<String> master = Optional.of("local[2]");
    List<String> setting = List.of("spark.executor.memory=1g");

    assertThat(
            SparkSubmit.command(
                Map.of("PATH", folder.toString()),
                master,
                setting,
                List.of("s.xml", "-o", "t.csv")))
        .startsWith(submit.toString(), "--class", "org.mechservice.spark.SparkStudy")
        .containsSequence("--master", "local[2]", "--conf", "spark.executor.memory=1g", "--jars")
        .endsWith("s.xml", "-o", "t.csv");
  }
}
