package org.mechservice.solver.ode.solve;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.events.EventFunctions;
import org.mechservice.solver.ode.events.NoEventLog;
import org.mechservice.solver.ode.step.RightHandSide;

/** Single events as the functions that an integration looks at, and those that have happened. */
final class ComposedEvents implements EventFunctions, SavedSystem {
  private final List<OdeEvent> events;

  /** Number of times that each event has happened. */
  private final long[] counts;

  private final List<FoundEvent> found = new ArrayList<>();

  /** State behind the last events, and when that was. */
  private double[] after = {};

  private double time = Double.NaN;
  private boolean terminal;

  /** Function that was not finite last; −1: none. */
  private int notFinite = -1;

  /** The relative tolerance of the integration. */
  private final double tolerance;

  private final NoEventLog noEvents;

  /**
   * @param tolerance relative one of the integration
   */
  ComposedEvents(List<OdeEvent> events, double tolerance) {
    this.events = events;
    this.tolerance = tolerance;
    noEvents = new NoEventLog(events.size());
    counts = new long[events.size()];
  }

  List<FoundEvent> found() {
    return found;
  }

  /** Returns the places at which events have not happened. */
  List<EventRemark> remarks() {
    return noEvents.entries().stream()
        .filter(entry -> entry.why() != NoEvent.PASSED_AT_START || counts[entry.function()] == 0)
        .map(entry -> new EventRemark(entry, events.get(entry.function()).name))
        .toList();
  }

  @Override
  public double resolution() {
    return tolerance;
  }

  @Override
  public void noEvent(int function, NoEvent why, double t, double value) {
    boolean hadOneThere = why == NoEvent.ZERO_AT_START && counts[function] > 0;
    if (!hadOneThere) {
      noEvents.note(function, why, t, value);
    }
  }

  /** Returns whether an event has ended the integration. */
  boolean terminal() {
    return terminal;
  }

  /** Returns whether the last events were at t. */
  boolean happenedAt(double t) {
    return time == t;
  }

  /** Returns the state behind the last events; not to be modified. */
  double[] after() {
    return after;
  }

  @Override
  public int count() {
    return counts.length;
  }

  @Override
  public void evaluate(double t, double[] y, double[] g) {
    for (int i = 0; i < counts.length; i++) {
      g[i] = events.get(i).function.value(t, y);
      notFinite = Double.isFinite(g[i]) ? notFinite : i;
    }
  }

  /** Returns what to call the function that was not finite last. */
  String notFinite() {
    return notFinite < 0 ? "" : title(notFinite);
  }

  @Override
  public Direction direction(int function) {
    return events.get(function).direction;
  }

  @Override
  public double hysteresis(int function) {
    return events.get(function).hysteresis;
  }

  @Override
  public Reaction occurred(double t, double[] y, boolean[] occurred) {
    double[] before = y.clone();
    boolean changed = false;
    for (int i = 0; i < counts.length; i++) {
      if (occurred[i]) {
        counts[i]++;
        terminal |= counts[i] >= events.get(i).last;
        changed |= events.get(i).action.isPresent();
        apply(i, t, y);
      }
    }
    time = t;
    after = y.clone();
    for (int i = 0; i < counts.length; i++) {
      if (occurred[i]) {
        found.add(new FoundEvent(i, events.get(i).name, t, before, after));
      }
    }
    if (terminal) {
      return Reaction.STOP;
    }
    return changed ? Reaction.RESTART : Reaction.CONTINUE;
  }

  private void apply(int event, double t, double[] y) {
    if (events.get(event).action.isEmpty()) {
      return;
    }
    events.get(event).action.get().apply(t, y);
    int component = RightHandSide.firstNotFinite(y);
    if (component >= 0) {
      throw new IllegalArgumentException(
          "the action of event "
              + title(event)
              + " at t = "
              + t
              + " has set y["
              + component
              + "] to "
              + y[component]
              + "; it must be finite");
    }
  }

  private String title(int event) {
    String name = events.get(event).name;
    return name.isEmpty() ? "" + event : event + " (" + name + ")";
  }

  /**
   * Looks for functions that are exactly zero at the start and leave zero in the one direction that
   * they are looked at; these are events of the start.
   *
   * @param y0 state at the start; overwritten by actions
   * @param ahead a place close ahead, and the solution there
   */
  void lookAtStart(double t0, double[] y0, double ahead, double[] yAhead) {
    boolean[] occurred = new boolean[counts.length];
    boolean any = false;
    for (int i = 0; i < counts.length; i++) {
      occurred[i] =
          zeroAtStart(i, t0, y0) && leaves(i, events.get(i).function.value(ahead, yAhead));
      any |= occurred[i];
    }
    if (any) {
      occurred(t0, y0, occurred);
    }
  }

  /** Returns whether any function with one direction is exactly zero. */
  boolean anyZeroAtStart(double t0, double[] y0) {
    for (int i = 0; i < counts.length; i++) {
      if (zeroAtStart(i, t0, y0)) {
        return true;
      }
    }
    return false;
  }

  private boolean zeroAtStart(int i, double t0, double[] y0) {
    return events.get(i).direction != Direction.EITHER && events.get(i).function.value(t0, y0) == 0;
  }

  private boolean leaves(int i, double value) {
    return events.get(i).direction == Direction.RISING ? value > 0 : value < 0;
  }

  /** {@inheritDoc} Events found before are not carried over, but for those of the last step. */
  @Override
  public void transfer(SavedState state) {
    for (int i = 0; i < counts.length; i++) {
      counts[i] = state.integer(counts[i]);
    }
    terminal = state.flag(terminal);
    time = state.number(time);
    after = transfer(state, after);
    noEvents.transfer(state);
  }

  /** Carries the events behind a time over, that are still to be told. */
  void transferFound(SavedState state, double reached, double direction) {
    List<FoundEvent> untold =
        found.stream().filter(event -> direction * (event.time() - reached) > 0).toList();
    int count = state.integer(untold.size());
    for (int k = 0; k < count; k++) {
      boolean known = k < untold.size();
      int index = state.integer(known ? untold.get(k).index() : 0);
      double at = state.number(known ? untold.get(k).time() : 0);
      double[] before = transfer(state, known ? untold.get(k).before() : new double[0]);
      double[] behind = transfer(state, known ? untold.get(k).after() : new double[0]);
      if (state.restoring()) {
        found.add(new FoundEvent(index, events.get(index).name, at, before, behind));
      }
    }
  }

  private static double[] transfer(SavedState state, double[] values) {
    int length = state.integer(values.length);
    double[] carried = state.restoring() ? new double[length] : values;
    state.numbers(carried);
    return carried;
  }
}
