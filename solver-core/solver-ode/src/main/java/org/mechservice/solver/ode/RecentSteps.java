package org.mechservice.solver.ode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The last steps tried, kept for the report of a failure. */
final class RecentSteps {
  private static final int KEPT = 10;

  private final double[] time = new double[KEPT];
  private final double[] stepSize = new double[KEPT];
  private final int[] order = new int[KEPT];
  private final double[] error = new double[KEPT];
  private final Attempt[] attempt = new Attempt[KEPT];
  private long recorded;

  RecentSteps() {
    Arrays.fill(attempt, Attempt.PASSED);
  }

  void clear() {
    recorded = 0;
  }

  /** Takes note of a step; for the arguments see {@link IntegrationFailure.StepRecord}. */
  void record(double time, double stepSize, int order, double error, Attempt attempt) {
    int slot = (int) (recorded % KEPT);
    this.time[slot] = time;
    this.stepSize[slot] = stepSize;
    this.order[slot] = order;
    this.error[slot] = error;
    this.attempt[slot] = attempt;
    recorded++;
  }

  /** Returns the steps kept, oldest first. */
  List<IntegrationFailure.StepRecord> list() {
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
  void transfer(StateTransfer state) {
    recorded = state.integer(recorded);
    state.numbers(time);
    state.numbers(stepSize);
    state.numbers(error);
    for (int slot = 0; slot < KEPT; slot++) {
      order[slot] = state.integer(order[slot]);
      attempt[slot] = Attempt.valueOf(state.text(attempt[slot].name()));
    }
  }
}
