package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.IntegrationMethod;

/**
 * Strict accuracy makes errors smaller at the same tolerances; standard accuracy is the default.
 */
class AccuracyTest {
  private static final double[] TOLERANCES = {1e-3, 1e-5, 1e-7, 1e-9};

  /**
   * A mass that a spring and a damper pull along q = cos t, in both forms. With stiff ones its own
   * motion decays at rates of 10 and 990 1/s. Without them it oscillates freely, which the stiff
   * methods do not suit: on resolved oscillations they keep to a hundredth of the tolerances in
   * every mode.
   */
  private static final class Pulled extends HarmonicOscillator implements ResidualModel {
    private final double stiffness;
    private final double damping;

    Pulled(boolean stiff) {
      stiffness = stiff ? 1e4 : 0;
      damping = stiff ? 1e3 : 0;
    }

    private double acceleration(double t, double[] y) {
      double off = y[0] - Math.cos(t);
      double fast = y[1] + Math.sin(t);
      return stiffness == 0 ? -y[0] : -Math.cos(t) - stiffness * off - damping * fast;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = acceleration(t, y);
      return REGULAR;
    }

    @Override
    public int residual(double t, double[] y, double[] yDot, double[] residual) {
      residual[0] = yDot[0] - y[1];
      residual[1] = yDot[1] - acceleration(t, y);
      return REGULAR;
    }
  }

  private static RunReport run(RunSettings settings, RecordedRows rows) throws IOException {
    boolean stiff = settings.integrator().startsWith("ode15s");
    RunRequest request = new RunRequest(settings, Set.of());
    return new RuntimeSolver().run(new Pulled(stiff), request, rows, new RunControl());
  }

  /** Largest error of q over the rows; columns are t, q, v. */
  private static double error(RecordedRows rows) {
    return rows.rows.stream()
        .mapToDouble(row -> Math.abs(row[1] - Math.cos(row[0])))
        .max()
        .orElseThrow();
  }

  private static RunSettings settings(IntegrationMethod method, double tolerance) {
    return new RunSettings(0, 20, 0.25, method.label(), tolerance, tolerance);
  }

  /**
   * A single run may be accurate by luck; the mean over the tolerances is not. A 20th of the
   * tolerances makes errors about 20 times smaller; a method of low order at loose tolerances gains
   * less, so a factor of 4 is required.
   */
  @ParameterizedTest
  @EnumSource
  void strictRunsHaveSmallerErrorsAtTheSameTolerances(IntegrationMethod method) throws IOException {
    double sumOfLogarithms = 0;
    for (double tolerance : TOLERANCES) {
      RunSettings settings = settings(method, tolerance);
      RecordedRows standard = new RecordedRows();
      RecordedRows strict = new RecordedRows();
      run(settings, standard);
      RunReport report = run(settings.withAccuracy(Accuracy.STRICT), strict);
      sumOfLogarithms += Math.log(error(strict) / error(standard));
      assertThat(report.asMap()).containsEntry("accuracy", "strict");
    }
    assertThat(Math.exp(sumOfLogarithms / TOLERANCES.length)).as("%s", method).isLessThan(0.25);
  }

  @ParameterizedTest
  @EnumSource
  void settingsThatNameNoAccuracyAreStandard(IntegrationMethod method) throws IOException {
    RunSettings settings = settings(method, 1e-6);
    RecordedRows unnamed = new RecordedRows();
    RecordedRows standard = new RecordedRows();
    RunReport report = run(settings, unnamed);
    run(settings.withAccuracy(Accuracy.STANDARD), standard);
    assertThat(unnamed.rows).usingRecursiveComparison().isEqualTo(standard.rows);
    assertThat(report.asMap()).doesNotContainKey("accuracy");
  }
}
