package org.mechservice.solver.ode.solve;

/** An event that has happened. */
public final class FoundEvent {
  private final int index;
  private final String name;
  private final double time;
  private final double[] before;
  private final double[] after;

  FoundEvent(int index, String name, double time, double[] before, double[] after) {
    this.index = index;
    this.name = name;
    this.time = time;
    this.before = before;
    this.after = after;
  }

  /** Returns which event it was, from 0 in the order in which they were given. */
  public int index() {
    return index;
  }

  /** Returns the event's name; empty if it has none. */
  public String name() {
    return name;
  }

  /** Returns when it happened. */
  public double time() {
    return time;
  }

  /** Returns a copy of the state before the action. */
  public double[] before() {
    return before.clone();
  }

  /** Returns a copy of the state after the actions of all events of that time. */
  public double[] after() {
    return after.clone();
  }

  void copyAfter(double[] y) {
    System.arraycopy(after, 0, y, 0, y.length);
  }

  @Override
  public String toString() {
    return "event " + index + (name.isEmpty() ? "" : " (" + name + ")") + " at t = " + time;
  }
}
