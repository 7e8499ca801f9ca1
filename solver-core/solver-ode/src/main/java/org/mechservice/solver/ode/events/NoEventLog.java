package org.mechservice.solver.ode.events;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;

/**
 * Places at which event functions had no event though they were at zero, beyond it, or changed
 * sign: the first of each kind for each function, and how many there were.
 */
public final class NoEventLog {
  /** Places of one kind, by function. */
  private static final class Places {
    private final long[] counts;
    private final double[] times;
    private final double[] values;

    Places(int functions) {
      counts = new long[functions];
      times = new double[functions];
      values = new double[functions];
    }
  }

  private final int functions;
  private final Map<NoEvent, Places> places = new EnumMap<>(NoEvent.class);

  /**
   * @param functions number of event functions
   */
  public NoEventLog(int functions) {
    this.functions = functions;
  }

  private Places of(NoEvent why) {
    return places.computeIfAbsent(why, kind -> new Places(functions));
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
    Places kind = of(why);
    if (kind.counts[function] == 0) {
      kind.times[function] = t;
      kind.values[function] = value;
    }
    kind.counts[function]++;
  }

  /** Returns all, by function and kind. */
  public List<Entry> entries() {
    List<Entry> entries = new ArrayList<>();
    for (int i = 0; i < functions; i++) {
      for (NoEvent why : NoEvent.values()) {
        Places kind = of(why);
        if (kind.counts[i] > 0) {
          entries.add(new Entry(i, why, kind.times[i], kind.values[i], kind.counts[i]));
        }
      }
    }
    return entries;
  }

  /** Carries all over. */
  public void transfer(SavedState state) {
    for (NoEvent why : NoEvent.values()) {
      Places kind = of(why);
      for (int i = 0; i < functions; i++) {
        kind.counts[i] = state.integer(kind.counts[i]);
      }
      state.numbers(kind.times);
      state.numbers(kind.values);
    }
  }
}
