package org.mechservice.benchmarks.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;

/** The reference of passages near a singular position. */
class FourBarInLineTest {
  private static final RunSettings RUN = new RunSettings(0, 2, 0.1, "ode113", 1e-8, 1e-10);

  private static StateDistance distance() {
    return new StateDistance(
        new ModelDescription(
            "bars",
            "DSR",
            java.util.List.of(
                new JointVariables("a", JointType.R), new JointVariables("b", JointType.R)),
            RUN));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-1, 1e-4, 1e-8})
  void bothCodesPassAndKeepLengthAndEnergy(double longer) {
    double[] times = {0, 0.4, 0.5, 1, 2};
    double[] start = {-1, -1, 0, 0};
    Reference reference =
        FourBarInLine.reference(longer, start, times, distance(), 60).orElseThrow();
    // tolerances of 1e-12 and 1e-13 in two codes
    assertThat(reference.worstFloor()).isLessThan(1e-10);
    for (double[] y : reference.states()) {
      double x = 3 + Math.cos(y[1]) - Math.cos(y[0]);
      double z = Math.sin(y[0]) - Math.sin(y[1]);
      assertThat(Math.hypot(x, z)).isCloseTo(3 + longer, within(1e-13));
      double energy = (y[2] * y[2] + y[3] * y[3]) / 6 - 4.905 * (Math.sin(y[0]) + Math.sin(y[1]));
      double first =
          -4.905 * (Math.sin(reference.states()[0][0]) + Math.sin(reference.states()[0][1]));
      assertThat(energy).isCloseTo(first, within(1e-10));
    }
  }
}
