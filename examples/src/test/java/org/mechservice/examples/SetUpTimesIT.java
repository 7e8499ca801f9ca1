package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Measures the paper's set-up times on this machine: docs/reports/set-up-times.md. */
@Tag("soak")
class SetUpTimesIT {
  private static final Path PAGE = WorkingTree.TOP.resolve("docs/reports/set-up-times.md");
  private static final int RUNS = 9;
  private static final int WARM_UP_RUNS = 20;

  @TempDir Path directory;
  private final List<String> page = new ArrayList<>();
  private int modelsMade;

  @Test
  void setUpTimesSizesAndCostAreWrittenDown() throws IOException {
    heading();
    setUpTimes();
    sizes();
    cost();
    Files.write(PAGE, page);

    assertThat(PAGE).content().contains("tR", "standalone JAR", "ode113");
  }

  private void heading() {
    line("# Set-up times, sizes and cost of the five-bar pendulum");
    line("");
    line(
        "Measured on %s by `mvn verify -Psoak`: %s %s, %d cores at load %.1f, Java %s. Times in ms,"
            + " median (least to largest) of %d runs.",
        LocalDate.now(ZoneOffset.UTC),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"),
        RUNS);
    line("");
  }

  private void setUpTimes() throws IOException {
    int port = Service.freePort();
    List<Report> cold = repeat(() -> simulate());
    List<Report> coldLocal = repeat(() -> simulate("--mode", "local"));
    Terminal.Running server = Service.startServer(directory, port);
    try (server) {
      String[] remote = {"--server", Service.url(port)};
      String[] local = {"--server", Service.url(port), "--mode", "local"};
      List<Path> toWarmUp = newModels(WARM_UP_RUNS);
      toWarmUp.forEach(model -> simulate(model, remote));
      toWarmUp.forEach(model -> simulate(model, local));
      List<Report> fresh = newModels(RUNS).stream().map(model -> simulate(model, remote)).toList();
      List<Report> freshLocal =
          newModels(RUNS).stream().map(model -> simulate(model, local)).toList();
      List<Report> again = repeat(() -> simulate(toWarmUp.get(0), remote));
      List<Report> againLocal = repeat(() -> simulate(toWarmUp.get(0), local));
      table(List.of(cold, fresh, again), List.of(coldLocal, freshLocal, againLocal));
    }
  }

  private void table(List<List<Report>> remoteRuns, List<List<Report>> localRuns) {
    line(
        "Cold: a new process with an embedded server for every run, which builds a small model of");
    line("its own while its ORB starts. Warm: a new client process");
    line(
        "for every run, on a server that has served %d runs, with a model new to it or",
        2 * WARM_UP_RUNS);
    line("known to it. Paper: on a 400-500 MHz Pentium.");
    line("");
    line("| | | cold | warm, new model | warm, known model | paper |");
    line("|---|---|---|---|---|---|");
    row("t1c", "file sent and treated, seen by the client", "100", remoteRuns);
    row("t1s", "of which in the server", "80", remoteRuns);
    row("tcc", "compiling, in the server", "210", remoteRuns);
    row("tR", "set-up of a remote run", "380", remoteRuns);
    row("t2c", "JARs seen by the client", "220", localRuns);
    row("t2s", "of which in the server", "110", localRuns);
    row("tL", "set-up of a local run", "620", localRuns);
    row("wallTime", "the run itself, 3 s of motion", "140", remoteRuns);
    line("");
  }

  /** Returns pendulums that no server has seen, each with another gravity in its last digits. */
  private List<Path> newModels(int count) throws IOException {
    String pendulum = Files.readString(WorkingTree.PENDULUM);
    List<Path> models = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Path model = Files.createTempFile(directory, "pendulum", ".xml");
      String gravity = "gz=\"-9.81" + String.format(Locale.ROOT, "%05d", ++modelsMade) + "\"";
      Files.writeString(model, pendulum.replace("gz=\"-9.81\"", gravity));
      models.add(model);
    }
    return models;
  }

  private void sizes() throws IOException {
    List<Path> scenes =
        List.of(
            WorkingTree.PENDULUM,
            WorkingTree.TOP.resolve("examples/five-point-suspension/five-point-suspension.xml"),
            WorkingTree.TOP.resolve("examples/driver/driver-c0.xml"));
    StringBuilder models = new StringBuilder("| model JAR |");
    StringBuilder standalone = new StringBuilder("| standalone JAR |");
    for (Path scene : scenes) {
      models.append(' ').append(built(scene)).append(" |");
      standalone.append(' ').append(built(scene, "--standalone")).append(" |");
    }
    Report local = simulate("--mode", "local");
    line(
        "All sizes are compressed sizes in bytes. The JARs hold ordinary class files with line"
            + " numbers and names; the paper's solver, with all its methods and integrators,"
            + " compares with the runtime JAR.");
    line("");
    line("| size in bytes | pendulum | five-point suspension | driver, C = 0 | paper |");
    line("|---|---|---|---|---|");
    line("%s 2200, 7100, 11800 |", models);
    line("| runtime JAR | %.0f | the same | the same | 125000 |", local.number("runtimeJarBytes"));
    line("%s |", standalone);
    line("");
    line(
        "MechML file of the pendulum: %d B, paper 4300 B. Its classes in the model JAR: %.0f B.",
        Files.size(WorkingTree.PENDULUM), local.number("modelClassBytes"));
    line("");
  }

  private long built(Path scene, String... options) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                "build",
                scene.toString(),
                "--user-code",
                scene.resolveSibling(".").toString(),
                "-o",
                "p.jar"));
    command.addAll(List.of(options));
    new Terminal(directory).mech(command.toArray(String[]::new)).orFail();
    return Files.size(directory.resolve("p.jar"));
  }

  private void cost() {
    line(
        "Error: largest difference of q and v from the reference up to 3 s, over 1 + |reference|.");
    line("");
    line("| integrator | rtol | atol | steps | rejected | evaluations | error | energy drift |");
    line("|---|---|---|---|---|---|---|---|");
    for (String integrator : List.of("DE", "ode113")) {
      for (String[] tolerance :
          new String[][] {{"1e-5", "1e-5"}, {"1e-5", "1e-7"}, {"1e-10", "1e-12"}}) {
        Report report =
            simulate(
                "--integrator",
                integrator,
                "--rtol",
                tolerance[0],
                "--atol",
                tolerance[1],
                "--out",
                "r.csv");
        double error = PendulumReference.errorOf(ResultRows.read(directory.resolve("r.csv")));
        line(
            "| %s | %s | %s | %.0f | %.0f | %.0f | %.1e | %.1e J |",
            integrator,
            tolerance[0],
            tolerance[1],
            report.number("steps"),
            report.number("rejectedSteps"),
            report.number("evaluations"),
            error,
            report.number("energyDrift"));
      }
    }
  }

  private Report simulate(String... options) {
    return simulate(WorkingTree.PENDULUM, options);
  }

  private Report simulate(Path model, String... options) {
    List<String> command = new ArrayList<>(List.of("simulate", model.toString(), "--json"));
    command.addAll(Arrays.asList(options));
    return Report.printedBy(new Terminal(directory).mech(command.toArray(String[]::new)));
  }

  private static List<Report> repeat(Supplier<Report> run) {
    return IntStream.range(0, RUNS).mapToObj(i -> run.get()).toList();
  }

  private void row(String key, String meaning, String paper, List<List<Report>> cases) {
    String times =
        cases.stream()
            .map(reports -> milliseconds(key, reports))
            .collect(Collectors.joining(" | "));
    line("| %s | %s | %s | %s |", key, meaning, times, paper);
  }

  private static String milliseconds(String key, List<Report> reports) {
    double[] times = reports.stream().mapToDouble(r -> 1000 * r.number(key)).sorted().toArray();
    return String.format(
        Locale.ROOT,
        "%.1f (%.1f to %.1f)",
        times[times.length / 2],
        times[0],
        times[times.length - 1]);
  }

  private void line(String format, Object... values) {
    page.add(String.format(Locale.ROOT, format, values));
  }
}
