package org.mechservice.solver.ode.step;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/** The last steps tried, kept for the report of a failure. */
public final class RecentSteps {
  private static final int KEPT = 10;

  private final double[] time = new double[KEPT];
  private final double[] stepSize = new double[KEPT];
  private final int[] order = new int[KEPT];
  private final double[] error = new double[KEPT];
  private final TrialOutcome[] attempt = new TrialOutcome[KEPT];
  private long recorded;

  public RecentSteps() {
    Arrays.fill(attempt, TrialOutcome.PASSED);
  }

  public void clear() {
    recorded = 0;
  }

  /** Takes note of a step; for the arguments see {@link IntegrationFailure.StepRecord}. */
  public void record(double time, double stepSize, int order, double error, TrialOutcome attempt) {
    int slot = (int) (recorded % KEPT);
    this.time[slot] = time;
    this.stepSize[slot] = stepSize;
    this.order[slot] = order;
    this.error[slot] = error;
    // Collectors make it cost more to store a reference than to compare it.
    if (this.attempt[slot] != attempt) {
      this.attempt[slot] = attempt;
    }
    recorded++;
  }

  /** Returns the steps kept, oldest first. */
  public List<IntegrationFailure.StepRecord> list() {
    List<IntegrationFailure.StepRecord> steps = new ArrayList<>(KEPT);
    for (long i = Math.max(0, recorded - KEPT); i < recorded; i++) {
      int slot = (int) (i % KEPT);
      steps.add(
          new IntegrationFailure.StepRecord(
              time[slot], stepSize[slot], order[slot], error[slot], attempt[slot]));
    }
    return List.copyOf(steps);
  }

  /** Carries the steps kept over. */
  public void transfer(SavedState state) {
    recorded = state.integer(recorded);
    state.numbers(time);
    state.numbers(stepSize);
    state.numbers(error);
    for (int slot = 0; slot < KEPT; slot++) {
      order[slot] = state.integer(order[slot]);
      attempt[slot] = TrialOutcome.valueOf(state.text(attempt[slot].name()));
    }
  }
}
