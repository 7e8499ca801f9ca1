package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** A run may be told to end where its energy balance no longer holds. */
class EnergyBalanceTest {
  /** A force that nobody accounts for: from t = 1 s on it puts energy in. */
  private static final class Pushed extends HarmonicOscillator {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      super.derivative(t, y, yDot);
      double late = Math.max(0, t - 1);
      yDot[1] -= 0.1 * late * late;
      return REGULAR;
    }
  }

  /** Loses energy to a damper, which is known. */
  private static final class Damped extends HarmonicOscillator implements PowerInput {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -y[0] - 0.4 * y[1];
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = -0.4 * y[1] * y[1];
      power[1] = Math.abs(power[0]);
    }
  }

  /**
   * A unit mass pulled by 3 N that friction of 5 N holds: it creeps at some 1e-6 m/s, and what is
   * pulled in is rubbed away, 1e5 times its kinetic energy in a tenth of a second.
   */
  private static final class Held extends HarmonicOscillator implements PowerInput {
    private static double friction(double speed) {
      return -5 * Math.tanh(speed / 1e-6);
    }

    @Override
    public void initialState(double[] y) {
      y[0] = 0;
      y[1] = 0;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = 3 + friction(y[1]);
      return REGULAR;
    }

    @Override
    public void energy(double t, double[] y, double[] energy) {
      energy[0] = 0.5 * y[1] * y[1];
      energy[1] = 0;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = (3 + friction(y[1])) * y[1];
      power[1] = 3 * Math.abs(y[1]) + Math.abs(friction(y[1]) * y[1]);
    }
  }

  private final RecordedRows rows = new RecordedRows();

  private RunReport run(Model model, OptionalDouble maxDrift, Set<ColumnGroup> columns)
      throws IOException {
    RunRequest request = new RunRequest(HarmonicOscillator.SETTINGS, columns, false, maxDrift);
    return new RuntimeSolver().run(model, request, rows, new RunControl(), Checkpoints.NONE);
  }

  /** The rows up to t = 1 hold it to the tolerances; the force needs half a second for 1e-3. */
  @Test
  void runEndsWithTheFirstRowThatHasDriftedTooFar() throws IOException {
    double bound = 1e-3;
    RunReport watched = run(new Pushed(), OptionalDouble.of(bound), Set.of(ColumnGroup.ENERGY));

    Failure failure = ((Outcome.Failed) watched.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.ENERGY_DRIFT);
    assertThat(failure.stepSize()).isPositive();
    assertThat(failure.order()).isPositive();
    assertThat(failure.cause()).contains("0.001 is allowed").contains(" J");
    assertThat(failure.advice()).contains("1.0E-10");
    double[] last = rows.rows.get(rows.rows.size() - 1);
    assertThat(failure.time()).isEqualTo(last[0]);
    double scale = 0;
    for (double[] row : rows.rows) {
      double drift = Math.abs(row[3] + row[4] - row[5] - 0.5);
      scale = Math.max(scale, Math.max(row[3], Math.abs(row[4] - 0.5)));
      assertThat(drift > bound * scale).isEqualTo(row == last);
    }
    assertThat(last[0]).isGreaterThan(1).isLessThan(2);
    assertThat(watched.rows()).isEqualTo(rows.rows.size());
  }

  @Test
  void runThatKeepsItsBalanceHasTheSameBits() throws IOException {
    RunReport plain = run(new Damped(), OptionalDouble.empty(), Set.of());
    RecordedRows watched = new RecordedRows();
    RunRequest request =
        new RunRequest(HarmonicOscillator.SETTINGS, Set.of(), false, OptionalDouble.of(1e-7));
    RunReport report = new RuntimeSolver().run(new Damped(), request, watched, new RunControl());

    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(report.steps()).isEqualTo(plain.steps());
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-8);
    assertThat(watched.rows).hasSameSizeAs(rows.rows);
    for (int i = 0; i < rows.rows.size(); i++) {
      assertThat(watched.rows.get(i)).containsExactly(rows.rows.get(i));
    }
  }

  /** At rest in the middle there is no energy to compare with, and none drifts. */
  @Test
  void mechanismAtRestHasNoDrift() throws IOException {
    HarmonicOscillator resting =
        new HarmonicOscillator() {
          @Override
          public void initialState(double[] y) {
            y[0] = 0;
            y[1] = 0;
          }
        };
    assertThat(run(resting, OptionalDouble.of(1e-12), Set.of()).outcome())
        .isEqualTo(new Outcome.Completed());
  }

  @Test
  void frictionAtRestIsJudgedByWhatFlowsThroughIt() throws IOException {
    RunSettings tenth = new RunSettings(0, 0.1, 0.01, "ode15s", 1e-8, 1e-10);
    RunRequest request = new RunRequest(tenth, Set.of(), false, OptionalDouble.of(1e-3));
    RunReport report = new RuntimeSolver().run(new Held(), request, rows, new RunControl());

    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    double speed = rows.rows.get(rows.rows.size() - 1)[2];
    assertThat(report.energyScale().orElseThrow()).isGreaterThan(1e4 * 0.5 * speed * speed);
  }

  @Test
  void workThatNobodyMeasuresLeavesNoDriftInTheReport() throws IOException {
    assertThat(run(new Damped(), OptionalDouble.empty(), Set.of()).energyDrift()).isEmpty();
    RunReport measured = run(new Damped(), OptionalDouble.empty(), Set.of(ColumnGroup.ENERGY));
    assertThat(measured.energyDrift()).isPresent();
  }

  @Test
  void modelWithoutEnergyIsRefused() {
    HarmonicOscillator oscillator = new HarmonicOscillator();
    ExplicitModel bare =
        new ExplicitModel() {
          @Override
          public ModelDescription description() {
            return oscillator.description();
          }

          @Override
          public void initialState(double[] y) {
            oscillator.initialState(y);
          }

          @Override
          public int derivative(double t, double[] y, double[] yDot) {
            return oscillator.derivative(t, y, yDot);
          }
        };
    assertThatThrownBy(() -> run(bare, OptionalDouble.of(1e-3), Set.of()))
        .hasMessageContaining("S-166")
        .hasMessageContaining("does not tell its energy");
  }
}
