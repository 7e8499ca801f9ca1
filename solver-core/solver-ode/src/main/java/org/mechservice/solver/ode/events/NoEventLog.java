package org.mechservice.solver.ode.events;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;

/**
 * Places at which event functions had no event though they were at zero, beyond it, or changed
 * sign: the first of each kind for each function, and how many there were.
 */
public final class NoEventLog {
  private static final int KINDS = NoEvent.values().length;

  private final long[] counts;
  private final double[] times;
  private final double[] values;

  /**
   * @param functions number of event functions
   */
  public NoEventLog(int functions) {
    counts = new long[functions * KINDS];
    times = new double[counts.length];
    values = new double[counts.length];
  }

  /**
   * Places of one kind for one function.
   *
   * @param function its index
   * @param why why it has no event there
   * @param time of the first place
   * @param value of the function at the first place, or beside it
   * @param count number of places
   */
  public record Entry(int function, NoEvent why, double time, double value, long count) {
    /** Returns what the function does there, as the rest of a sentence that begins with it. */
    public String text() {
      String more = count > 1 ? ", and " + (count - 1) + " more times later" : "";
      return switch (why) {
        case ZERO_AT_START ->
            "is exactly zero at the start and leaves zero at once; it is not known from which side"
                + " it came, so that does not count as an event";
        case PASSED_AT_START ->
            "is "
                + (float) value
                + " at the start, beyond zero in the direction looked for, and has not passed zero"
                + " that way since, so that there was no event";
        case TOUCH ->
            "comes to zero at t = "
                + time
                + (value == 0 ? "" : " up to " + (float) value)
                + " and turns back"
                + more
                + "; a touch without a change of sign does not count as an event";
        case POLE ->
            "changes its sign through infinity at t = "
                + time
                + more
                + "; a pole does not count as an event";
      };
    }
  }

  /** Takes note of a place. */
  public void note(int function, NoEvent why, double t, double value) {
    int k = function * KINDS + why.ordinal();
    if (counts[k] == 0) {
      times[k] = t;
      values[k] = value;
    }
    counts[k]++;
  }

  /** Returns all, by function and kind. */
  public List<Entry> entries() {
    List<Entry> entries = new ArrayList<>();
    for (int k = 0; k < counts.length; k++) {
      if (counts[k] > 0) {
        NoEvent why = NoEvent.values()[k % KINDS];
        entries.add(new Entry(k / KINDS, why, times[k], values[k], counts[k]));
      }
    }
    return entries;
  }

  /** Carries all over. */
  public void transfer(SavedState state) {
    for (int k = 0; k < counts.length; k++) {
      counts[k] = state.integer(counts[k]);
    }
    state.numbers(times);
    state.numbers(values);
  }
}
