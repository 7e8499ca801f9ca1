package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Measures on this machine what the paper measured on its own: docs/reports/set-up-times.md. */
@Tag("soak")
class SetUpTimesIT {
  private static final Path PAGE = WorkingTree.TOP.resolve("docs/reports/set-up-times.md");
  private static final int RUNS = 9;
  private static final int WARM_UP_RUNS = 20;

  @TempDir Path directory;
  private final List<String> page = new ArrayList<>();

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
        "Measured on %s by `mvn verify -Psoak`: %s %s, %d cores, Java %s. Times in ms, median (least to largest) of %d runs.",
        LocalDate.now(ZoneOffset.UTC),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        System.getProperty("java.version"),
        RUNS);
    line("");
  }

  private void setUpTimes() {
    int port = Service.freePort();
    List<Report> cold = repeat(() -> simulate());
    List<Report> coldLocal = repeat(() -> simulate("--mode", "local"));
    Terminal.Running server = Service.startServer(directory, port);
    try (server) {
      warmUp(port);
      List<Report> warm = repeat(() -> simulate("--server", Service.url(port)));
      List<Report> warmLocal =
          repeat(() -> simulate("--mode", "local", "--server", Service.url(port)));
      line("Cold: a new process with an embedded server for every run. Warm: a new client process");
      line("for every run on a server that has served %d runs. Paper: on a", 2 * WARM_UP_RUNS);
      line("400-500 MHz Pentium.");
      line("");
      line("| | | cold | warm | paper |");
      line("|---|---|---|---|---|");
      row("t1c", "file sent and treated, seen by the client", cold, warm, "100");
      row("t1s", "of which in the server", cold, warm, "80");
      row("tcc", "compiling, in the server", cold, warm, "210");
      row("tR", "set-up of a remote run", cold, warm, "380");
      row("t2c", "JARs made and fetched, seen by the client", coldLocal, warmLocal, "220");
      row("t2s", "of which in the server", coldLocal, warmLocal, "110");
      row("tL", "set-up of a local run", coldLocal, warmLocal, "620");
      row("wallTime", "the run itself, 3 s of motion", cold, warm, "140");
      line("");
    }
  }

  private void warmUp(int port) {
    for (int i = 0; i < WARM_UP_RUNS; i++) {
      simulate("--server", Service.url(port));
      simulate("--mode", "local", "--server", Service.url(port));
    }
  }

  private void sizes() throws IOException {
    new Terminal(directory)
        .mech("build", WorkingTree.PENDULUM.toString(), "-o", "p.jar", "--standalone")
        .orFail();
    Report local = simulate("--mode", "local");
    line("| size in bytes | | paper |");
    line("|---|---|---|");
    line("| MechML file | %d | 4300 |", Files.size(WorkingTree.PENDULUM));
    line("| model JAR | %.0f | 2200 |", local.number("modelJarBytes"));
    line("| its classes, compressed | %.0f | |", local.number("modelClassBytes"));
    line("| runtime JAR | %.0f | 125000 |", local.number("runtimeJarBytes"));
    line("| standalone JAR | %d | |", Files.size(directory.resolve("p.jar")));
    line("");
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
        double error = PendulumReference.errorOf(ResultTable.read(directory.resolve("r.csv")));
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
    List<String> command =
        new ArrayList<>(List.of("simulate", WorkingTree.PENDULUM.toString(), "--json"));
    command.addAll(Arrays.asList(options));
    return Report.printedBy(new Terminal(directory).mech(command.toArray(String[]::new)));
  }

  private static List<Report> repeat(Supplier<Report> run) {
    return IntStream.range(0, RUNS).mapToObj(i -> run.get()).toList();
  }

  private void row(String key, String meaning, List<Report> cold, List<Report> warm, String paper) {
    line(
        "| %s | %s | %s | %s | %s |",
        key, meaning, milliseconds(key, cold), milliseconds(key, warm), paper);
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
