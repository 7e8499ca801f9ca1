package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.Variable;

/** Random models with all elements move the same in all formulations. */
@Tag("slow")
class RandomElementsTest {
  private static final Path PAGE = Path.of("..", "docs", "reports", "random-elements.md");
  private static final int SOAKED = 35;

  /** Formulation and integrator; the first is the reference. */
  private static final List<List<String>> METHODS =
      List.of(
          List.of("DSR", "ode113"),
          List.of("DTR", "DE"),
          List.of("RR", "ode15sR"),
          List.of("RR-JF", "ode15sR"));

  /** Four hundred tolerances of 1e-10 in some thousand steps, with stiff friction in contacts. */
  private static final double BOUND = 4e-8;

  private static Trajectory run(String text, List<String> method) throws Exception {
    return MechModel.of("m.xml", text)
        .formulation(method.get(0))
        .integrator(method.get(1))
        .simulate();
  }

  /** Returns the largest difference in the last row, relative to the largest number or 1. */
  private static double difference(Trajectory one, Trajectory other) {
    double largest = 0;
    double size = 1;
    for (Variable column : one.columns()) {
      double[] expected = one.column(column.name());
      double[] actual = other.column(column.name());
      int last = expected.length - 1;
      largest = Math.max(largest, Math.abs(actual[last] - expected[last]));
      size = Math.max(size, Math.abs(expected[last]));
    }
    return largest / size;
  }

  /** Compares the methods on one model; returns the difference of each from the first. */
  private static Map<String, Double> compare(long seed, boolean closed) throws Exception {
    String text = new RandomElements(seed, closed).text();
    Trajectory reference = run(text, METHODS.get(0));
    Map<String, Double> differences = new LinkedHashMap<>();
    for (List<String> method : METHODS.subList(1, METHODS.size())) {
      // DTR is for trees.
      if (!closed || !method.get(0).equals("DTR")) {
        double difference = difference(reference, run(text, method));
        assertThat(difference).as("seed %d, %s", seed, method).isLessThan(BOUND);
        differences.put(method.get(0), difference);
      }
    }
    return differences;
  }

  @ParameterizedTest
  @CsvSource({"1, false", "2, true"})
  void formulationsMoveTheSame(long seed, boolean closed) throws Exception {
    compare(seed, closed);
  }

  @Test
  @Tag("soak")
  void manyMoveTheSame() throws Exception {
    StringBuilder page = new StringBuilder();
    page.append(
        String.format(
            Locale.ROOT,
            "# Random models with all elements%n%n%d models without loops and %d with a coupling, a"
                + " rolling wheel with its redundant equations and a rope of fixed length, over 0.15 s at tolerances of 1e-10:"
                + " states, a filter, controllers, samples, an input, a table, a map, a driven ball, gravity over time, couplings with"
                + " backlash, an elastic rope over a pulley, a contact of spheres whose friction"
                + " sticks, a tyre on those without loops. Seeds 1 to %d. Written on %s by"
                + " `RandomElementsTest` under `mvn verify -Psoak`, %s %s, Java %s;"
                + " every build runs two of them. The largest difference of"
                + " the last row from DSR with ode113, relative to the largest number in"
                + " it.%n%n| models | formulation | largest difference | bound |%n|---|---|---|---|%n",
            SOAKED,
            SOAKED,
            SOAKED,
            LocalDate.now(ZoneOffset.UTC),
            System.getProperty("os.name"),
            System.getProperty("os.arch"),
            System.getProperty("java.version")));
    for (boolean closed : new boolean[] {false, true}) {
      Map<String, Double> largest = new LinkedHashMap<>();
      for (int seed = 1; seed <= SOAKED; seed++) {
        compare(seed, closed).forEach((method, one) -> largest.merge(method, one, Math::max));
      }
      largest.forEach(
          (method, one) ->
              page.append(
                  String.format(
                      Locale.ROOT,
                      "| %s | %s | %.1e | %.0e |%n",
                      closed ? "closed" : "trees",
                      method,
                      one,
                      BOUND)));
    }
    Files.writeString(PAGE, page.toString());
  }
}
