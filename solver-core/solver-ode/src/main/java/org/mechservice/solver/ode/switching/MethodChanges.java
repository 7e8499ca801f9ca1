package org.mechservice.solver.ode.switching;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.ode.Integrator.MethodChange;
import org.mechservice.solver.ode.SavedState;

/** The first changes of method in an integration, and how many there were. */
final class MethodChanges {
  private static final int REMEMBERED = 16;

  private final double[] time = new double[REMEMBERED];
  private final double[] stepSize = new double[REMEMBERED];
  private final boolean[] stiff = new boolean[REMEMBERED];
  private long count;

  void clear() {
    count = 0;
  }

  void record(double t, double h, boolean toStiff) {
    if (count < REMEMBERED) {
      int slot = (int) count;
      time[slot] = t;
      stepSize[slot] = h;
      stiff[slot] = toStiff;
    }
    count++;
  }

  long count() {
    return count;
  }

  /** Returns the first ones. */
  List<MethodChange> list() {
    List<MethodChange> changes = new ArrayList<>();
    for (int i = 0; i < Math.min(count, REMEMBERED); i++) {
      changes.add(new MethodChange(time[i], stiff[i], stepSize[i]));
    }
    return changes;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    count = state.integer(count);
    state.numbers(time);
    state.numbers(stepSize);
    for (int i = 0; i < REMEMBERED; i++) {
      stiff[i] = state.flag(stiff[i]);
    }
  }
}
