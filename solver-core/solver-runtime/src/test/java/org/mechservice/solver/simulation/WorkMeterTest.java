package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/** Work of what has no energy of its own. */
class WorkMeterTest {
  private static final double DAMPING = 0.4;

  /** A unit mass on a unit spring with a damper: q'' = −q − c q'. */
  private static final class Damped extends HarmonicOscillator implements PowerInput {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -y[0] - DAMPING * y[1];
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = -DAMPING * y[1] * y[1];
      power[1] = Math.abs(power[0]);
    }
  }

  private final RecordedRows rows = new RecordedRows();

  @Test
  void workIsWhatTheEnergyHasLostAtEveryRow() throws IOException {
    RunReport report = run(Set.of(ColumnGroup.ENERGY));

    int kinetic = 3;
    for (double[] row : rows.rows) {
      // E(0) = 1/2; a quadrature of degree 5 over steps that hold 1e-10.
      assertThat(row[kinetic] + row[kinetic + 1] - row[kinetic + 2]).isCloseTo(0.5, within(1e-8));
    }
    assertThat(rows.rows.get(rows.rows.size() - 1)[kinetic + 2]).isLessThan(-0.1);
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-8);
  }

  /** The same, pushed as well: work is put in and taken out for good. */
  private static final class Pushed extends HarmonicOscillator implements PowerInput {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -y[0] - DAMPING * y[1] + StrictMath.sin(t);
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = (StrictMath.sin(t) - DAMPING * y[1]) * y[1];
      power[1] = Math.abs(power[0]);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 6, 8, 10, 12})
  void workIsAsAccurateAsTheMotionWhateverTheTolerance(int k) throws IOException {
    // One row at the end: the rule goes over whole steps, with nothing but them to bound it.
    double tolerance = StrictMath.pow(10, -k);
    RunSettings settings =
        new RunSettings(0, 20, 20, "ode113", tolerance, tolerance, Double.POSITIVE_INFINITY, 0, 0);
    RunReport report =
        new RuntimeSolver()
            .run(
                new Pushed(),
                new RunRequest(settings, Set.of(ColumnGroup.ENERGY)),
                rows,
                new RunControl());
    // Errors of 20 s, of which the damper forgets those older than some seconds.
    assertThat(report.energyDrift().orElseThrow()).isLessThan(30 * tolerance);
  }

  @Test
  void nothingIsSaidOfADriftWhereWorkIsNotMeasured() throws IOException {
    assertThat(run(Set.of()).energyDrift()).isEmpty();
  }

  private RunReport run(Set<ColumnGroup> columns) throws IOException {
    return new RuntimeSolver()
        .run(
            new Damped(),
            new RunRequest(HarmonicOscillator.SETTINGS, columns),
            rows,
            new RunControl());
  }
}
