package org.mechservice.cli.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
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
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
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
class SweepCommandTest {
  private static final Path SEAT = Path.of("../examples/sweep/seat.xml");
  private static final int LAST_COLUMNS = 4; // t, height.q, height.v, energy left

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
    assertThat(sweep(SEAT, "--set", "damping=500:4500:5", "--set", "stiffness=20000,3.1e4"))
        .as(err.toString())
        .isZero();
    List<List<String>> rows = cells(out.toString());
    assertThat(rows.get(0))
        .containsExactly(
            "damping",
            "stiffness",
            "outcome",
            "code",
            "message",
            "t",
            "height.q",
            "height.v",
            "energy left",
            "steps",
            "evaluations");
    assertThat(rows).hasSize(11);
    for (List<String> row : rows.subList(1, 11)) {
      assertThat(row.get(2)).isEqualTo("completed");
      List<String> alone =
          lastRowOfOneRun("--set", "damping=" + row.get(0), "--set", "stiffness=" + row.get(1));
      assertThat(row.subList(5, 5 + LAST_COLUMNS)).isEqualTo(alone);
    }
  }

  @Test
  void rowsAreInTheOrderOfTheGridHoweverManyRunAtOnce() {
    String[] grid = {"--set", "damping=1000:4000:7", "--set", "stiffness=1e4,2e4"};
    assertThat(sweep(SEAT, grid)).isZero();
    String many = out.toString();
    assertThat(sweep(SEAT, "--set", grid[1], "--set", grid[3], "--at-once", "1")).isZero();
    assertThat(out.toString()).isEqualTo(many);
    assertThat(cells(many).stream().skip(1).map(row -> row.get(0) + " " + row.get(1)))
        .startsWith("1000.0 1e4", "1000.0 2e4", "1500.0 1e4");
  }

  @Test
  void everyHostRunsSome() {
    MechServerProcess other =
        MechServerProcess.start(new ServerSettings("other", "127.0.0.1", 0, 0));
    try (SimHostProcess one =
            SimHostProcess.start(new HostSettings(other.url(), "one", "127.0.0.1", 0, 1));
        SimHostProcess two =
            SimHostProcess.start(new HostSettings(other.url(), "two", "127.0.0.1", 0, 2))) {
      String[] words = {"--set", "damping=100:5000:40", "--figures", "where", "--take", "t"};
      List<String> line = new ArrayList<>(List.of("sweep", SEAT.toString(), "--quiet"));
      line.addAll(List.of("--server", other.url()));
      line.addAll(List.of(words));
      assertThat(mech(line.toArray(String[]::new))).as(err.toString()).isZero();
      assertThat(out.toString()).contains("\"remote, host one\"", "\"remote, host two\"");
      assertThat(one.address()).isNotEqualTo(two.address());
    } finally {
      other.close();
    }
  }

  @Test
  void failuresAreRowsWithCodeAndMessageAndTheOthersGoOn() throws Exception {
    Path file = folder.resolve("r.csv");
    assertThat(sweep(SEAT, "--set", "damping=500,1/0,2*x,1000,-1e300", "--out", file.toString()))
        .isEqualTo(ExitStatus.SIMULATION_FAILED);
    List<List<String>> rows = cells(Files.readString(file));
    assertThat(rows.stream().skip(1).map(row -> row.get(1)))
        .containsExactly("completed", "failed", "failed", "completed", "failed");
    assertThat(rows.get(2).get(2)).startsWith("M-");
    assertThat(rows.get(3).get(2)).startsWith("M-022");
    assertThat(Files.readString(file)).contains("is not a known name here");
    assertThat(rows.get(5).get(2)).startsWith("N-");
    assertThat(err.toString()).contains("3 of 5 points failed, the first at {damping=1/0}");
  }

  @Test
  void figuresAndColumnsAskedForArePutOut() {
    assertThat(
            sweep(
                SEAT,
                "--set",
                "damping=500,600",
                "--take",
                "energy left",
                "--figures",
                "outcome,rows"))
        .as(err.toString())
        .isZero();
    assertThat(out.toString())
        .startsWith("damping,outcome,code,message,energy left,outcome,rows\n500,completed,,,")
        .contains(",completed,21\n");
  }

  @Test
  void jsonHasTheSameRows() {
    assertThat(sweep(SEAT, "--set", "damping=500,2*x", "--json"))
        .isEqualTo(ExitStatus.SIMULATION_FAILED);
    JsonObject all = JsonParser.parseString(out.toString()).getAsJsonObject();
    assertThat(all.get("points").getAsInt()).isEqualTo(2);
    assertThat(all.get("failed").getAsInt()).isEqualTo(1);
    JsonArray rows = all.getAsJsonArray("rows");
    JsonObject first = rows.get(0).getAsJsonObject();
    assertThat(first.getAsJsonObject("parameters").get("damping").getAsString()).isEqualTo("500");
    assertThat(first.getAsJsonObject("values").get("t").getAsDouble()).isEqualTo(1);
    assertThat(first.getAsJsonObject("report").get("steps").getAsLong()).isPositive();
    assertThat(rows.get(1).getAsJsonObject().get("code").getAsString()).isEqualTo("M-022");
  }

  /** A count, a measure and a text. */
  private static final String FIGURES = "steps,simulatedTime,integrator";

  /** Has a process sweep and kills it after some points; returns how many were finished. */
  private int killed(Path model, String set, Path file) throws Exception {
    Path part = folder.resolve(file.getFileName() + ".part");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Mech.class.getName(),
                "sweep",
                model.toString(),
                "--server",
                server.url(),
                "--set",
                set,
                "--figures",
                FIGURES,
                "--out",
                file.toString())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      Eventually.holds(() -> Files.exists(part) && Files.readAllLines(part).size() > 3);
    } finally {
      process.destroyForcibly().waitFor();
    }
    return Files.readAllLines(part).size() - 1;
  }

  @Test
  void killedSweepGoesOnWhereItWasAndEndsWithTheSameBytes() throws Exception {
    Path whole = folder.resolve("whole.csv");
    Path parts = folder.resolve("parts.csv");
    Path part = folder.resolve("parts.csv.part");
    String set = "damping=100:5000:100";
    int finished = killed(SEAT, set, parts);
    assertThat(finished).isLessThan(100);
    // It was killed while it wrote the next line.
    Files.writeString(part, "{\"point\":5,\"outco", StandardOpenOption.APPEND);
    assertThat(
            mech(
                "sweep",
                SEAT.toString(),
                "--server",
                server.url(),
                "--set",
                set,
                "--figures",
                FIGURES,
                "--out",
                parts.toString()))
        .as(err.toString())
        .isZero();
    assertThat(err.toString()).startsWith(finished + " of 100 points were finished before");
    assertThat(part).doesNotExist();
    assertThat(sweep(SEAT, "--set", set, "--figures", FIGURES, "--out", whole.toString())).isZero();
    assertThat(parts).hasSameBinaryContentAs(whole);
  }

  @Test
  void pointsOfAnotherSweepAreNotTakenOver() throws Exception {
    Path file = folder.resolve("parts.csv");
    Path part = folder.resolve("parts.csv.part");
    String left = "{\"model\":\"other.xml\"}\n{\"point\":1}\n";
    Files.writeString(part, left);
    assertThat(sweep(SEAT, "--set", "damping=500:4500:5", "--out", file.toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-165 ").contains("parts.csv.part");
    assertThat(file).doesNotExist();
    assertThat(part).hasContent(left);
  }

  @Test
  void sweepThatIsRefusedAtOnceStandsInNoOnesWay() throws Exception {
    Path file = folder.resolve("parts.csv");
    assertThat(sweep(SEAT, "--set", "colour=1:2:2", "--out", file.toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(folder.resolve("parts.csv.part")).doesNotExist();
    assertThat(sweep(SEAT, "--set", "damping=500,4500", "--out", file.toString())).isZero();
  }

  @Test
  void hostThatDiesMeanwhileCostsNoPoint() throws Exception {
    MechServerProcess other =
        MechServerProcess.start(new ServerSettings("frail", "127.0.0.1", 0, 0));
    SimHostProcess dies =
        SimHostProcess.start(new HostSettings(other.url(), "dies", "127.0.0.1", 0, 2));
    try (SimHostProcess stays =
        SimHostProcess.start(new HostSettings(other.url(), "stays", "127.0.0.1", 0, 1))) {
      Thread killer = whenPointsAreFinished(folder.resolve("r.csv.part"), dies::close);
      assertThat(
              mech(
                  "sweep",
                  SEAT.toString(),
                  "--quiet",
                  "--server",
                  other.url(),
                  "--set",
                  "damping=100:5000:60",
                  "--out",
                  folder.resolve("r.csv").toString()))
          .as(err.toString())
          .isZero();
      killer.join();
      assertThat(
              cells(Files.readString(folder.resolve("r.csv"))).stream()
                  .skip(1)
                  .map(row -> row.get(1)))
          .hasSize(60)
          .containsOnly("completed");
      assertThat(stays.address()).isNotEmpty();
    } finally {
      other.close();
    }
  }

  /** Lets something happen in the midst of a sweep. */
  private static Thread whenPointsAreFinished(Path part, Runnable event) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (!Files.exists(part) || Files.readAllLines(part).size() < 4) {
                  Thread.sleep(20);
                }
              } catch (IOException | InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              event.run();
            });
    thread.start();
    return thread;
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "damping=1:2 | S-041 --set damping=1:2: a range has three parts, not 2; write NAME=",
        "damping=1:2:x | S-041 --set damping=1:2:x: \"x\" is no whole number of values",
        "damping=1:2:1 | S-041 --set damping=1:2:1: a range has 2 values or more, not 1",
        "damping=a:2:3 | S-041 --set damping=a:2:3: \"a\" is no number",
        "damping=0:1e999:3 | S-041 --set damping=0:1e999:3: \"1e999\" is not finite",
        "damping | S-041 --set damping: it names no parameter",
        "damping= | S-041 --set damping=: it has no value",
        "damping=1,,2 | S-041 --set damping=1,,2: a value between commas is missing",
        "damping=1:2:2000000 | S-041 the grid has more than 1000000 points",
        "nosuch=1,2 | S-016 seat.xml: M-014 set names parameter \"nosuch\"",
      })
  @ParameterizedTest
  void whatCannotBeSweptIsSaidInOneLine(String set, String message) {
    assertThat(sweep(SEAT, "--set", set)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith(message).hasLineCount(1);
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void columnsAndFiguresThatThereAreNotAreNamed() {
    assertThat(sweep(SEAT, "--set", "damping=1,2", "--take", "x")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .startsWith("S-041 --take: the runs put out no column \"x\"; there are t, height.q");
    assertThat(sweep(SEAT, "--set", "damping=1,2", "--figures", "y"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .startsWith("S-041 --figures: the run report has no \"y\"; there are scene, outcome");
    assertThat(sweep(SEAT, "--set", "damping=1", "--set", "damping=2"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 a parameter is swept twice");
  }

  @Test
  void lostServerLeavesWhatIsFinished() throws Exception {
    MechServerProcess doomed =
        MechServerProcess.start(new ServerSettings("doomed", "127.0.0.1", 0, 1));
    Path file = folder.resolve("r.csv");
    Path part = folder.resolve("r.csv.part");
    Thread killer = whenPointsAreFinished(part, doomed::close);
    int status =
        mech(
            "sweep",
            SEAT.toString(),
            "--quiet",
            "--server",
            doomed.url(),
            "--set",
            "damping=100:5000:4000",
            "--out",
            file.toString());
    killer.join();
    assertThat(status).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).contains(" of 4000 points are finished; they are in ");
    int finished = Files.readAllLines(file).size() - 1;
    assertThat(finished).isBetween(3, 3999);
    assertThat(Files.readAllLines(part)).hasSize(finished + 1);
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
