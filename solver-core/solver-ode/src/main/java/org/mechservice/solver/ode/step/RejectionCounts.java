package org.mechservice.solver.ode.step;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/** Counts the components that caused the rejection of steps. */
final class RejectionCounts {
  private double[] inaccurate = {};
  private double[] unsolved = {};

  void begin(int dimension) {
    inaccurate = new double[dimension];
    unsolved = new double[dimension];
  }

  /**
   * Takes note of a rejected step.
   *
   * @param component −1 if none can be named
   */
  void rejected(TrialOutcome attempt, int component) {
    if (component >= 0) {
      (attempt == TrialOutcome.TOO_INACCURATE ? inaccurate : unsolved)[component]++;
    }
  }

  /** Returns the components that were named, those named most often first. */
  List<IntegrationStatistics.Limit> list() {
    List<IntegrationStatistics.Limit> limits = new ArrayList<>();
    for (int l = 0; l < inaccurate.length; l++) {
      if (inaccurate[l] + unsolved[l] > 0) {
        limits.add(new IntegrationStatistics.Limit(l, (long) inaccurate[l], (long) unsolved[l]));
      }
    }
    limits.sort(Comparator.comparingLong(limit -> -limit.inaccurate() - limit.unsolved()));
    return limits;
  }

  /** Carries the counts over. */
  void transfer(SavedState state) {
    state.numbers(inaccurate);
    state.numbers(unsolved);
  }
}
