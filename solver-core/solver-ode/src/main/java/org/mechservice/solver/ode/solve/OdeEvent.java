package org.mechservice.solver.ode.solve;

import java.util.Objects;
import java.util.Optional;
import org.mechservice.solver.ode.events.EventFunctions.Direction;

/**
 * A function g(t, y) of the solution whose changes of sign are events, and what happens at them.
 * Immutable; each method but {@link #when} returns another event.
 *
 * <pre>{@code
 * OdeEvent.when((t, y) -> y[0]).falling().then((t, y) -> y[1] = -0.9 * y[1])     // bounce
 * OdeEvent.when((t, y) -> y[0]).falling().terminal()                             // end at the floor
 * }</pre>
 *
 * <p>Directions are those in which the integration runs: integrated backwards, a function that
 * grows with t is falling. A function that is exactly zero at the start has an event there if it
 * was given one direction and leaves zero in that direction: a ball on the floor that moves down
 * hits it at once. Otherwise it has none there, and its first return to zero is its first event.
 */
public final class OdeEvent {
  private static final long NEVER = Long.MAX_VALUE;

  final Function function;
  final Direction direction;
  final double hysteresis;
  final long last;
  final Optional<Action> action;
  final String name;

  private OdeEvent(
      Function function,
      Direction direction,
      double hysteresis,
      long last,
      Optional<Action> action,
      String name) {
    this.function = function;
    this.direction = direction;
    this.hysteresis = hysteresis;
    this.last = last;
    this.action = action;
    this.name = name;
  }

  /** A function of the solution. */
  @FunctionalInterface
  public interface Function {
    /**
     * Returns g(t, y), which should be continuous along a solution.
     *
     * @param y not to be modified
     */
    double value(double t, double[] y);
  }

  /** The action at an event. */
  @FunctionalInterface
  public interface Action {
    /**
     * Changes the state, or the equations by whatever they look at. The integration begins anew
     * from there, at order 1.
     *
     * @param y state just behind the event; may be overwritten
     */
    void apply(double t, double[] y);
  }

  /** Returns the event of a change of sign in either direction, which is only recorded. */
  public static OdeEvent when(Function function) {
    Objects.requireNonNull(function, "the function of an event is null; give g(t, y)");
    return new OdeEvent(function, Direction.EITHER, 0, NEVER, Optional.empty(), "");
  }

  /** Returns the event of changes from negative to positive only. */
  public OdeEvent rising() {
    return new OdeEvent(function, Direction.RISING, hysteresis, last, action, name);
  }

  /** Returns the event of changes from positive to negative only. */
  public OdeEvent falling() {
    return new OdeEvent(function, Direction.FALLING, hysteresis, last, action, name);
  }

  /** Returns the event that ends the integration. */
  public OdeEvent terminal() {
    return terminalAfter(1);
  }

  /**
   * Returns the event that ends the integration when it happens for the given time.
   *
   * @throws IllegalArgumentException if the count is not positive
   */
  public OdeEvent terminalAfter(long count) {
    if (count < 1) {
      throw new IllegalArgumentException(
          "an event is terminal after " + count + " times; it must be at least 1");
    }
    return new OdeEvent(function, direction, hysteresis, count, action, name);
  }

  /** Returns the event with something that happens at it; a terminal event ends behind that. */
  public OdeEvent then(Action change) {
    Objects.requireNonNull(
        change, "what happens at an event is null; leave then(...) out if nothing does");
    return new OdeEvent(function, direction, hysteresis, last, Optional.of(change), name);
  }

  /**
   * Returns the event with a distance from zero that g must have had since its last event before
   * its next change of sign is one.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public OdeEvent hysteresis(double distance) {
    if (!(distance >= 0) || !Double.isFinite(distance)) {
      throw new IllegalArgumentException(
          "the hysteresis of an event is " + distance + "; it must be finite and not negative");
    }
    return new OdeEvent(function, direction, distance, last, action, name);
  }

  /** Returns the event with a name by which messages and {@link FoundEvent} call it. */
  public OdeEvent named(String title) {
    Objects.requireNonNull(title, "the name of an event is null; leave named(...) out");
    return new OdeEvent(function, direction, hysteresis, last, action, title);
  }
}
