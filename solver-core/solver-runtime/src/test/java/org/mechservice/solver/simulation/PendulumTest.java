package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.FiveBarPendulum;

/** The paper's pendulum from tree to rows, against a 128-bit reference solution. */
class PendulumTest {
  /**
   * Bounds of the project: 1000 rtol at most, up to 3 s, where the motion amplifies errors by some
   * hundreds.
   */
  @CsvSource({
    "DE, 1e-5, 1e-5, 1e-3",
    "ode113, 1e-5, 1e-5, 1e-3",
    "DE, 1e-10, 1e-12, 1e-8",
    "ode113, 1e-10, 1e-12, 1e-8"
  })
  @ParameterizedTest
  void endsWhereTheReferenceDoes(String integrator, double rtol, double atol, double bound)
      throws IOException {
    RecordedRows rows = new RecordedRows();
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, rtol, atol);
    RunReport report =
        new RuntimeSolver()
            .run(
                new DataDrivenModel(FiveBarPendulum.mechanism(), settings),
                new RunRequest(settings, Set.of()),
                rows,
                new RunControl());
    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(rows.rows).hasSize(301);
    assertThat(worstError(rows)).isLessThan(bound);
  }

  /** max |x − ref| / (1 + |ref|) over q and v at the reference times. */
  private static double worstError(RecordedRows rows) throws IOException {
    double worst = 0;
    for (double[] reference : referenceStates()) {
      double[] row = rows.rows.get((int) Math.round(reference[0] * 100));
      for (int i = 1; i <= 10; i++) {
        worst = Math.max(worst, Math.abs(row[i] - reference[i]) / (1 + Math.abs(reference[i])));
      }
    }
    return worst;
  }

  private static List<double[]> referenceStates() throws IOException {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                Objects.requireNonNull(
                    DataDrivenModel.class.getResourceAsStream("pendulum5.states.csv")),
                StandardCharsets.UTF_8))) {
      return lines
          .lines()
          .skip(1)
          .map(
              line -> Arrays.stream(line.split(",", -1)).mapToDouble(Double::parseDouble).toArray())
          .toList();
    }
  }
}
