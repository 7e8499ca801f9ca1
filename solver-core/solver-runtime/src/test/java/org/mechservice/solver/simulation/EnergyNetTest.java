package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** An energy balance that is far off tells of a motion that is wrong. */
class EnergyNetTest {
  /** A force that nobody accounts for. */
  private static final class Pushed extends HarmonicOscillator {
    private final double push;
    private final double far;

    Pushed(double push, double far) {
      this.push = push;
      this.far = far;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      super.derivative(t, y, yDot);
      yDot[1] += push;
      return REGULAR;
    }

    @Override
    public void initialState(double[] y) {
      y[0] = far;
      y[1] = 0;
    }
  }

  private static RunReport run(HarmonicOscillator model, double tolerance, boolean strict)
      throws IOException {
    RunSettings settings = new RunSettings(0, 2, 0.25, "ode113", tolerance, tolerance);
    RunRequest request = new RunRequest(settings, Set.of(), strict, OptionalDouble.empty());
    return new RuntimeSolver().run(model, request, new RecordedRows(), new RunControl());
  }

  @Test
  void driftOfAFewHundredthsOfTheScaleIsToldWithItsPart() throws IOException {
    RunReport report = run(new Pushed(0.1, 1), 1e-8, false);
    assertThat(report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(report.notes())
        .singleElement()
        .satisfies(
            note -> {
              assertThat(note.code()).isEqualTo(MessageCode.ENERGY_BALANCE_OFF);
              assertThat(note.warning()).isTrue();
              assertThat(note.text())
                  .containsPattern(
                      "by up to 0\\.\\d+ J, which is 0\\.\\d+ of the energy that has moved");
            });
  }

  @Test
  void itEndsAStrictRun() throws IOException {
    Failure failure = ((Outcome.Failed) run(new Pushed(0.1, 1), 1e-8, true).outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.ENERGY_BALANCE_OFF);
  }

  @Test
  void noToleranceAllowsMoreThanAFewHundredths() throws IOException {
    assertThat(run(new Pushed(0.1, 1), 1e-2, false).notes())
        .extracting(RunNotes.Note::code)
        .containsExactly(MessageCode.ENERGY_BALANCE_OFF);
  }

  @Test
  void rightMotionsAndRestAreNot() throws IOException {
    assertThat(run(new HarmonicOscillator(), 1e-8, true).notes()).isEmpty();
    assertThat(run(new HarmonicOscillator(), 1e-3, true).notes()).isEmpty();
    assertThat(run(new Pushed(0, 0), 1e-8, true).notes()).isEmpty();
  }

  /** Takes the speed away between two rows: a damper that is not seen to work at any of them. */
  private static final class Braked extends HarmonicOscillator implements PowerInput {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      super.derivative(t, y, yDot);
      yDot[1] += brake(t) * y[1];
      return REGULAR;
    }

    private static double brake(double t) {
      double way = (t - 1.1) / 0.05;
      return Math.abs(way) < 1 ? -20 * (1 - way * way) * (1 - way * way) : 0;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = brake(t) * y[1] * y[1];
      power[1] = Math.abs(power[0]);
    }
  }

  @Test
  void workBetweenTwoRowsIsInTheBalance() throws IOException {
    assertThat(run(new Braked(), 1e-8, false).notes()).isEmpty();
  }

  /** A damper of which a part is not in the power. */
  private static final class Leaking extends HarmonicOscillator implements PowerInput {
    private final double told;

    Leaking(double told) {
      this.told = told;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      super.derivative(t, y, yDot);
      yDot[1] -= 0.4 * y[1];
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = -0.4 * told * y[1] * y[1];
      power[1] = -power[0];
    }
  }

  @Test
  void theWorkOfStepsIsRightToFarLessThanTheLimit() throws IOException {
    assertThat(run(new Leaking(1), 1e-6, false).notes()).isEmpty();
    assertThat(run(new Leaking(1), 1e-3, false).notes()).isEmpty();
    assertThat(run(new Leaking(0.9), 1e-6, false).notes())
        .extracting(RunNotes.Note::code)
        .containsExactly(MessageCode.ENERGY_BALANCE_OFF);
  }

  /** Damped, and braked by a pulse; of either a part may be missing in the power. */
  private static final class Counted extends HarmonicOscillator implements PowerInput {
    private final double damper;
    private final double pulse;
    private long derivatives;
    private long powers;

    Counted(double damper, double pulse) {
      this.damper = damper;
      this.pulse = pulse;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      derivatives++;
      super.derivative(t, y, yDot);
      yDot[1] += (Braked.brake(t) - 0.01) * y[1];
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      powers++;
      power[0] = (pulse * Braked.brake(t) - 0.01 * damper) * y[1] * y[1];
      power[1] = -power[0];
    }
  }

  private static RunReport longRun(Counted model, double tolerance) throws IOException {
    RunSettings settings = new RunSettings(0, 60, 60, "ode113", tolerance, tolerance);
    RunRequest request = new RunRequest(settings, Set.of(), false, OptionalDouble.empty());
    return new RuntimeSolver().run(model, request, new RecordedRows(), new RunControl());
  }

  @Test
  void thePowerIsEvaluatedInFewStepsAndNothingIsMissed() throws IOException {
    Counted right = new Counted(1, 1);
    assertThat(longRun(right, 1e-9).notes()).isEmpty();
    for (double tolerance : new double[] {1e-9, 1e-12}) {
      assertThat(longRun(new Counted(1, 1), tolerance).notes()).isEmpty();
      // The pulse takes 0.35 J of 0.5 J; longer steps of looser tolerances pass over it.
      assertThat(longRun(new Counted(1, 0.9), tolerance).notes())
          .as("pulse at %s", tolerance)
          .extracting(RunNotes.Note::code)
          .containsExactly(MessageCode.ENERGY_BALANCE_OFF);
      assertThat(longRun(new Counted(0.8, 1), tolerance).notes())
          .as("damper at %s", tolerance)
          .extracting(RunNotes.Note::code)
          .containsExactly(MessageCode.ENERGY_BALANCE_OFF);
    }
    // Two derivatives in a step, and 32 steps in a swing of the power, of which a cubic needs 13.
    assertThat(right.powers).isLessThan(right.derivatives / 2 * 13 / 32);
  }
}
