package org.mechservice.sim.service.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.ConfinementTest;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.guard.worker.WorkerMain;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;

/** Writes down what the wall of this machine keeps in, and what it costs. */
@Tag("soak")
class UserCodeWallsPageTest {
  private static final Path PAGE = Path.of("../../docs/reports/user-code-walls.md");
  private static final int REPEATS = 25;
  private static final WorkerBounds BOUNDS = new WorkerBounds(1 << 28, 600);

  private final List<String> lines = new ArrayList<>();
  private final Confinement wall = Confinement.ofThisMachine();
  private final Confinement none = Confinement.none("for comparison");

  /** Does something behind a wall or none. */
  private interface Work {
    void behind(Confinement confinement) throws Exception;
  }

  private void line(String format, Object... values) {
    lines.add(String.format(Locale.ROOT, format, values));
  }

  @Test
  void pageOfTheWall() throws Exception {
    assumeTrue(wall.stands(), () -> "no confinement on this machine: " + wall.text());
    line("# The walls around user code%n");
    line(
        "User force classes run in a worker process behind two walls"
            + " ([service.md](../service.md#user-code)): an allow-list of bytecode, and confinement"
            + " by the operating system. The classes that the first wall refuses are in"
            + " `EscapeClassesTest`. This page is about the second wall alone: the program"
            + " `EscapeAttempts` uses all of `java.base`, the only module of either process. Ways"
            + " that lead to a path of the confinement, such as `/java/lib`, lead nowhere in an"
            + " ordinary process.%n");
    line(
        "Measured on %s by `mvn verify -Psoak`: %s; JDK %s, %s %s, %d processors.%n",
        LocalDate.now(ZoneOffset.UTC),
        wall.text(),
        Runtime.version(),
        System.getProperty("os.name"),
        System.getProperty("os.version"),
        Runtime.getRuntime().availableProcessors());
    addWays();
    line("%n## Cost%n");
    line("Medians of %d, with the quartiles; the two are measured in turn.%n", REPEATS);
    line("| | ordinary process | behind the wall |");
    line("|---|---|---|");
    addCost("a Java program that tries nothing, from start to end, ms", this::runNothing);
    WorkerOrder order = HarmlessRun.order();
    addCost(
        "a run of one body with a user force, in a worker of its own, ms",
        confinement -> compute(order, confinement));
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }

  private void addWays() throws Exception {
    Map<String, Boolean> outside = ConfinementTest.ways(none, "POSIX_SPAWN");
    Map<String, Boolean> inside = ConfinementTest.ways(wall, "POSIX_SPAWN");
    line("| what the program tries | ordinary process | behind the wall |");
    line("|---|---|---|");
    inside.forEach(
        (way, works) ->
            line(
                "| %s | %s | %s |",
                way, Boolean.TRUE.equals(outside.get(way)) ? "works" : "-", works ? "works" : "-"));
    assertThat(inside).doesNotContainValue(true);
  }

  private void addCost(String what, Work work) throws Exception {
    double[] outside = new double[REPEATS];
    double[] inside = new double[REPEATS];
    work.behind(none);
    work.behind(wall);
    for (int i = 0; i < REPEATS; i++) {
      outside[i] = millis(work, none);
      inside[i] = millis(work, wall);
    }
    line("| %s | %s | %s |", what, spread(outside), spread(inside));
  }

  private static double millis(Work work, Confinement confinement) throws Exception {
    long start = System.nanoTime();
    work.behind(confinement);
    return (System.nanoTime() - start) * 1e-6;
  }

  private static String spread(double[] values) {
    Arrays.sort(values);
    return String.format(
        Locale.ROOT,
        "%.0f (%.0f to %.0f)",
        values[REPEATS / 2],
        values[REPEATS / 4],
        values[3 * REPEATS / 4]);
  }

  /** A worker that is sent no order ends at once. */
  private void runNothing(Confinement confinement) throws Exception {
    Process started =
        confinement
            .command(BOUNDS, WorkerMain.class, List.of())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    started.getOutputStream().close();
    started.waitFor();
  }

  private static void compute(WorkerOrder order, Confinement confinement) throws IOException {
    HarmlessRun.report(order, new WorkerProcess(confinement, BOUNDS));
  }
}
