package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** A run that changes its method where the motion gets stiff says so, and when. */
class SwitchingRunTest {
  /** Far over critically damped: from rest, q falls as exp(−t / 1e4) after 1e-4 s. */
  private static final class DampedOscillator extends HarmonicOscillator implements PowerInput {
    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -y[0] - 1e4 * y[1];
      return REGULAR;
    }

    @Override
    public void power(double t, double[] y, double[] power) {
      power[0] = -1e4 * y[1] * y[1];
      power[1] = Math.abs(power[0]);
    }
  }

  private static RunReport run(HarmonicOscillator model, RecordedRows rows) throws IOException {
    RunRequest request =
        new RunRequest(
            new RunSettings(0, 20, 0.25, "switching", 1e-6, 1e-9),
            EnumSet.noneOf(ColumnGroup.class));
    return new RuntimeSolver().run(model, request, rows, new RunControl());
  }

  @Test
  void changeIsNotedWithTimeStepAndReason() throws IOException {
    RecordedRows rows = new RecordedRows();
    RunReport report = run(new DampedOscillator(), rows);
    assertThat(report.outcome()).isInstanceOf(Outcome.Completed.class);
    List<RunNotes.Note> notes = report.notes();
    assertThat(notes).hasSize(1);
    assertThat(notes.get(0).code()).isEqualTo(MessageCode.METHOD_SWITCHED);
    assertThat(notes.get(0).time()).isBetween(1e-4, 0.1);
    assertThat(notes.get(0).text())
        .startsWith("The method changes from ode113 to ode15s: ")
        .contains(" s.");
    assertThat(report.factorisations()).isPositive();
    double[] last = rows.rows.get(rows.rows.size() - 1);
    assertThat(last[1]).isCloseTo(StrictMath.exp(-20 / 1e4), within(1e-6));
  }

  @Test
  void runThatIsNotStiffHasNothingToSay() throws IOException {
    RunReport report = run(new HarmonicOscillator(), new RecordedRows());
    assertThat(report.notes()).isEmpty();
    assertThat(report.factorisations()).isZero();
  }
}
