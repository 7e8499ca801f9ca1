package org.mechservice.solver.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.closure.LoopComparison;
import org.mechservice.solver.closure.LoopComparison.LeftOut;
import org.mechservice.solver.dynamics.TreeComparison;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

/** Writes docs/reports/formulations.md: how far formulations differ on large random sets. */
@Tag("soak")
class FormulationsReportTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "formulations.md");
  private static final int TREES = 500;
  private static final int MOST_BODIES = 100;
  private static final int LOOPS = 1000;
  private static final String COLUMNS =
      " | of | median | 90 % | 99 % | largest | beyond bound |\n|---|---|---|---|---|---|---|";

  private final StringBuilder page = new StringBuilder();
  private int beyond;

  @Test
  void formulationsAgreeOnLargeRandomSets() throws IOException {
    line("# The formulations against each other");
    line("");
    line(
        "Measured on %s by `mvn verify -Psoak`: %s %s, Java %s. Errors are of arithmetic, not of"
            + " time steps, and nearly the same on every machine. A seeded slice of both sets runs"
            + " in `mvn verify`.",
        LocalDate.now(ZoneId.systemDefault()),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        System.getProperty("java.version"));
    trees();
    loops();
    Files.writeString(PAGE, page);
    assertThat(beyond).as("errors beyond their bounds").isZero();
  }

  private void line(String format, Object... values) {
    page.append(values.length == 0 ? format : String.format(Locale.ROOT, format, values))
        .append('\n');
  }

  private void rows(String kind, Map<String, ErrorSample> samples) {
    line("");
    line("| " + kind + COLUMNS);
    samples.forEach(
        (name, sample) -> {
          line("| %s | %s |", name, sample.cells());
          beyond += sample.above();
        });
  }

  private static ErrorSample of(Map<String, ErrorSample> samples, String name) {
    return samples.computeIfAbsent(name, key -> new ErrorSample());
  }

  private void trees() {
    Map<String, ErrorSample> backward = new LinkedHashMap<>();
    Map<String, ErrorSample> forward = new LinkedHashMap<>();
    Map<String, ErrorSample> parts = new LinkedHashMap<>();
    double hardest = 0;
    int velocities = 0;
    for (long seed = 1; seed <= TREES; seed++) {
      long s = seed;
      Mechanism tree = RandomTrees.ofAllJoints(seed, 1 + (int) (seed % MOST_BODIES));
      TreeComparison compared = TreeComparison.of(tree, seed, true);
      double bound = compared.forwardBound();
      compared
          .backward()
          .forEach((name, error) -> of(backward, name).add(s, error, TreeComparison.BACKWARD));
      compared
          .forward()
          .forEach(
              (name, error) -> {
                of(forward, name).add(s, error, bound);
                of(parts, name).add(s, error / bound, 1);
              });
      hardest = Math.max(hardest, compared.condition());
      velocities = Math.max(velocities, compared.velocities());
    }
    line("");
    line("## Open trees");
    line("");
    line(
        "%d trees, seeds 1 to %d, of 1 to %d bodies (five of each number), up to %d velocities,"
            + " joints of all nine types drawn alike, half of them against the file's sense,"
            + " oblique axes, random forces in all joints and on all bodies. `global` is the"
            + " independent formulation in maximal coordinates, six unknowns per body; RR is its"
            + " residual solved with the mass matrix of RR-JF.",
        TREES, TREES, MOST_BODIES, velocities);
    line("");
    line(
        "Backward error: |M a + b - tau| over |M| |a| + |b - tau|, by the Newton-Euler residual;"
            + " bound %.0e.",
        TreeComparison.BACKWARD);
    rows("formulation", backward);
    line("");
    line(
        "Forward difference from DSR: largest difference of an acceleration over 1 + the largest"
            + " acceleration; bound 100 epsilon times the condition of the mass matrix scaled to a"
            + " unit diagonal, at least 1e-11. The largest condition was %.1e.",
        hardest);
    rows("formulation", forward);
    line("");
    line("The same as part of each tree's bound:");
    rows("formulation", parts);
    parts.values().forEach(sample -> beyond -= sample.above());
  }

  private void loops() {
    Map<String, ErrorSample> forward = new LinkedHashMap<>();
    Map<String, ErrorSample> parts = new LinkedHashMap<>();
    Map<String, ErrorSample> reactions = new LinkedHashMap<>();
    Map<LeftOut, Integer> leftOut = new EnumMap<>(LeftOut.class);
    Map<Integer, Integer> freedoms = new TreeMap<>();
    int redundant = 0;
    int compared = 0;
    long seed = 0;
    while (compared < LOOPS) {
      seed++;
      long s = seed;
      Mechanism mechanism = LoopComparison.mechanism(seed);
      Optional<LeftOut> why = LoopComparison.leftOut(mechanism);
      if (why.isPresent()) {
        leftOut.merge(why.get(), 1, Integer::sum);
        continue;
      }
      LoopComparison comparison = LoopComparison.of(mechanism);
      double bound = comparison.forwardBound();
      comparison
          .forward()
          .forEach(
              (name, error) -> {
                of(forward, name).add(s, error, bound);
                of(parts, name).add(s, error / bound, 1);
              });
      of(reactions, "DSR, both closures").add(s, comparison.missing(), LoopComparison.MISSING);
      freedoms.merge(comparison.freedom(), 1, Integer::sum);
      redundant += comparison.redundant() > 0 ? 1 : 0;
      compared++;
    }
    line("");
    line("## Closed loops");
    line("");
    line(
        "%d mechanisms of 2 to 8 bodies with one or two loops against maximal coordinates: trees as"
            + " above, closed by cut joints of eight types, rods with and without mass, points on"
            + " planes and on lines. %d of them have redundant equations; degrees of freedom: %s"
            + " (freedom=count).",
        LOOPS, redundant, freedoms);
    line("");
    line("Seeds 1 to %d were drawn for this; left out were:", seed);
    line("");
    leftOut.forEach((why, count) -> line("- %d: %s", count, why.words()));
    line("");
    line(
        "Largest difference of an acceleration over 1 + the largest acceleration; bound 100 epsilon"
            + " times the condition of the scaled mass matrix times the root of that of the scaled"
            + " J J^T, at least 1e-11.");
    rows("formulation", forward);
    line("");
    line("The same as part of each mechanism's bound:");
    rows("formulation", parts);
    parts.values().forEach(sample -> beyond -= sample.above());
    line("");
    line(
        "Reactions: the largest force or moment missing to move a body as it moves, when joints,"
            + " rods, planes and lines push as reported, over 1 + the largest reaction; bound"
            + " %.0e.",
        LoopComparison.MISSING);
    rows("formulation", reactions);
  }
}
