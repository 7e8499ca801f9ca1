package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.PowerInput;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;

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
    public double power(double t, double[] y) {
      return -DAMPING * y[1] * y[1];
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
