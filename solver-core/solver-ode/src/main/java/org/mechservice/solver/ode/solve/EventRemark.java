package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.events.EventFunctions.NoEvent;
import org.mechservice.solver.ode.events.NoEventLog;

/**
 * A place at which an event has not happened though its function was at zero, beyond it, or changed
 * its sign there.
 */
public final class EventRemark {
  private final NoEventLog.Entry entry;
  private final String name;

  EventRemark(NoEventLog.Entry entry, String name) {
    this.entry = entry;
    this.name = name;
  }

  /** Returns which event it is, from 0 in the order in which they were given. */
  public int index() {
    return entry.function();
  }

  /** Returns the event's name; empty if it has none. */
  public String name() {
    return name;
  }

  /** Returns why it has not happened. */
  public NoEvent reason() {
    return entry.why();
  }

  /** Returns where, the first time. */
  public double time() {
    return entry.time();
  }

  /** Returns the value of the function there, or beside it. */
  public double value() {
    return entry.value();
  }

  /** Returns how many times. */
  public long count() {
    return entry.count();
  }

  @Override
  public String toString() {
    String title = entry.function() + (name.isEmpty() ? "" : " (" + name + ")");
    return "the function of event " + title + " " + entry.text();
  }
}
