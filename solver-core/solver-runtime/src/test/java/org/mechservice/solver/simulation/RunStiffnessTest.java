package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.analysis.equation.FastSpectrum;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/** A run is called stiff by its eigenvalues, whatever the tolerance and however it ends. */
class RunStiffnessTest {
  /** A unit mass with x'' = −2 ζ ω x' − ω² x, ω = 1000 rad/s. */
  private static final class Damped extends HarmonicOscillator {
    private static final double RATE = 1000;

    private final double ratio;
    private final RunControl control = new RunControl();
    private long evaluations;
    private long stopAt = Long.MAX_VALUE;

    Damped(double ratio) {
      this.ratio = ratio;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      evaluations++;
      if (evaluations == stopAt) {
        control.stop();
      }
      yDot[0] = y[1];
      yDot[1] = -2 * ratio * RATE * y[1] - RATE * RATE * y[0];
      return REGULAR;
    }

    RunReport run(String integrator, double length, double tolerance) throws IOException {
      RunSettings settings =
          new RunSettings(0, length, length / 4, integrator, tolerance, tolerance);
      RunRequest request = new RunRequest(settings, Set.of());
      return new RuntimeSolver().run(this, request, new RecordedRows(), control);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "0.3, 0.45, false",
    "0.3, 2, true",
    "1, 0.45, false",
    "1, 2, true",
    "0.06, 2, true",
    "0.03, 2, false",
    "0, 0.45, false",
    "0, 2, false"
  })
  void verdictIsThatOfTheEigenvaluesAtEveryTolerance(double ratio, double length, boolean stiff)
      throws IOException {
    for (double tolerance : new double[] {1e-3, 1e-6, 1e-9}) {
      for (String integrator : new String[] {"ode113", "DE"}) {
        assertThat(new Damped(ratio).run(integrator, length, tolerance).stiffnessSuspected())
            .as("%s at %s", integrator, tolerance)
            .isEqualTo(stiff);
      }
    }
  }

  @Test
  void runThatChangesItsMethodHasTheVerdictToo() throws IOException {
    assertThat(new Damped(1).run("switching", 2, 1e-6).stiffnessSuspected()).isTrue();
  }

  /** 20000 evaluations are some 10 s of 1000: less than a tenth, and some 10000 time constants. */
  @Test
  void runThatIsStoppedEarlyHasItsVerdictWithoutAnyFurtherEvaluation() throws IOException {
    Damped model = new Damped(1);
    model.stopAt = 20_000;
    RunReport report = model.run("ode113", 1000, 1e-6);
    assertThat(report.outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(report.timeReached()).isBetween(1.0, 100.0);
    assertThat(report.asMap()).containsEntry("stiffness", "suspected");
    assertThat(model.evaluations).isEqualTo(20_000);
  }

  /** λ = −ζ ω ± i ω √(1 − ζ²). */
  @Test
  void spectrumIsThatOfTheOscillator() {
    Optional<FastSpectrum.Found> found =
        new FastSpectrum(new Damped(0.6)).at(0, new double[] {0.5, -3});
    assertThat(found)
        .hasValueSatisfying(
            spectrum -> {
              int at = spectrum.deciding();
              assertThat(spectrum.real()[at]).isCloseTo(-600, within(1e-4));
              assertThat(Math.abs(spectrum.imaginary()[at])).isCloseTo(800, within(1e-4));
            });
  }
}
