package org.mechservice.benchmarks.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.report.measure.ReportProgress;

/** The studies that need no service. */
class IntegratorStudiesTest {
  private static final StudyContext CONTEXT =
      new StudyContext(
          () -> {
            throw new IllegalStateException("no service is asked for");
          },
          true,
          List.of(),
          ReportProgress.SILENT);

  @TempDir Path folder;

  private List<String[]> figures(MethodStudy study) throws IOException {
    study.write(folder, CONTEXT);
    List<String[]> rows = new ArrayList<>();
    for (String line : Files.readAllLines(folder.resolve("stability-" + study.name() + ".csv"))) {
      rows.add(line.split(",", -1));
    }
    return rows;
  }

  /**
   * Backward Euler with the first NDF's κ: |1/(1 − z)| < 1 on the imaginary axis, at every size.
   */
  @Test
  void implicitMethodsOfOrdersOneAndTwoNeverLetAnUndampedOscillatorGrow() throws IOException {
    boolean implicit = false;
    int looked = 0;
    for (String[] row : figures(new GrowthStudy(CONTEXT))) {
      implicit |= row[0].contains("ode15s");
      if (implicit && row.length == 4 && List.of("1", "2").contains(row[0])) {
        assertThat(Double.parseDouble(row[3])).isLessThan(1e-9);
        looked++;
      }
    }
    assertThat(implicit).isTrue();
    // Each of both orders at more than one size.
    assertThat(looked).isGreaterThan(2);
  }

  @Test
  void noiseFarBelowTheToleranceCostsNoSteps() throws IOException {
    int looked = 0;
    for (String[] row : figures(new NoiseStudy(CONTEXT))) {
      boolean figure = row.length == 7 && !row[0].equals("integrator");
      if (figure && Double.parseDouble(row[2]) <= 1e-6 * Double.parseDouble(row[1])) {
        // A decision that falls the other way by rounding changes some hundred steps by a tenth.
        assertThat(Double.parseDouble(row[4])).isBetween(0.8, 1.25);
        looked++;
      }
    }
    assertThat(looked).isGreaterThan(10);
  }

  @Test
  void everyStudyHasANameOfItsOwn() {
    assertThat(MethodStudy.all(CONTEXT))
        .extracting(MethodStudy::name)
        .doesNotHaveDuplicates()
        .hasSize(10);
  }
}
