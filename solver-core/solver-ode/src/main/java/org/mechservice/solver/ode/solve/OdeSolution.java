package org.mechservice.solver.ode.solve;

import java.util.AbstractList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator.MethodChange;

/**
 * The result of an integration: the solution from {@link #start} to {@link #end}, to be evaluated
 * anywhere between, its events, its costs, and why it ended.
 *
 * <p>The solution is that of the method's own polynomials, to the order of each step and without
 * evaluating the problem. At an event that has changed the state, {@link #at} gives the state
 * behind it; {@link FoundEvent#before} gives the other. Components that follow from others ({@code
 * CompletedSystem}) are interpolated like these. May be read by several threads.
 */
public final class OdeSolution {
  private static final double[] NOT_ASKED = {};

  private final Interval interval;
  private final EndReason endReason;
  private final Optional<IntegrationFailure> failure;
  private final Optional<KeptSteps> kept;
  private final List<FoundEvent> events;
  private final List<EventRemark> eventRemarks;
  private final IntegrationStatistics statistics;
  private final List<MethodChange> methodChanges;
  private final Supplier<OdeCheckpoint> checkpoint;

  OdeSolution(
      Interval interval,
      EndReason endReason,
      Optional<IntegrationFailure> failure,
      Optional<KeptSteps> kept,
      List<FoundEvent> events,
      List<EventRemark> eventRemarks,
      IntegrationStatistics statistics,
      List<MethodChange> methodChanges,
      Supplier<OdeCheckpoint> checkpoint) {
    this.interval = interval;
    this.endReason = endReason;
    this.failure = failure;
    this.kept = kept;
    this.events = List.copyOf(events);
    this.eventRemarks = eventRemarks;
    this.statistics = statistics;
    this.methodChanges = List.copyOf(methodChanges);
    this.checkpoint = checkpoint;
  }

  /** Where the solution begins and ends, its states there, and where it was to end. */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  record Interval(double start, double[] y0, double end, double[] y1, double requestedEnd) {}

  /**
   * One accepted step.
   *
   * @param start where it begins
   * @param end where it ends
   * @param order of the formula used
   */
  public record Step(double start, double end, int order) {}

  /** Returns where the solution begins. */
  public double start() {
    return interval.start();
  }

  /** Returns where the solution ends: the end asked for, or what was reached of it. */
  public double end() {
    return interval.end();
  }

  /** Returns the end asked for. */
  public double requestedEnd() {
    return interval.requestedEnd();
  }

  /** Returns a copy of the state at the start; consistent, for a problem in residual form. */
  public double[] startState() {
    return interval.y0().clone();
  }

  /** Returns a copy of the state at the end. */
  public double[] endState() {
    return interval.y1().clone();
  }

  /** Returns why the integration has ended. */
  public EndReason endReason() {
    return endReason;
  }

  /** Returns why the integration could not go on; empty if it did not fail. */
  public Optional<IntegrationFailure> failure() {
    return failure;
  }

  /** Returns what the integration cost. */
  public IntegrationStatistics statistics() {
    return statistics;
  }

  /** Returns where {@link OdeMethod#AUTO} changed its method, the first sixteen places. */
  public List<MethodChange> methodChanges() {
    return methodChanges;
  }

  /** Returns the events that have happened, in the order of integration. */
  public List<FoundEvent> events() {
    return events;
  }

  /**
   * Returns what is no event although it may look like one: functions that touch zero and turn
   * back, that change sign through infinity, that are zero at the start and leave it at once, or
   * that are beyond zero at the start and have had no event since. Each kind stands once for each
   * event.
   */
  public List<EventRemark> eventRemarks() {
    return eventRemarks;
  }

  /**
   * Returns the accepted steps.
   *
   * @throws IllegalStateException if they were not kept
   */
  public List<Step> steps() {
    KeptSteps steps = requireKept();
    return new AbstractList<>() {
      @Override
      public Step get(int i) {
        return new Step(steps.start(i), steps.end(i), steps.order(i));
      }

      @Override
      public int size() {
        return steps.count();
      }
    };
  }

  /**
   * Returns the ends of all accepted steps, the start being the first.
   *
   * @throws IllegalStateException if they were not kept
   */
  public double[] times() {
    KeptSteps steps = requireKept();
    double[] times = new double[steps.count() + 1];
    times[0] = start();
    for (int i = 0; i < steps.count(); i++) {
      times[i + 1] = steps.end(i);
    }
    return times;
  }

  /**
   * Returns the state at any place.
   *
   * @param t from {@link #start} to {@link #end}, both included
   * @throws IllegalArgumentException if {@code t} lies outside
   * @throws IllegalStateException if the steps were not kept
   */
  public double[] at(double t) {
    double[] y = new double[interval.y0().length];
    at(t, y);
    return y;
  }

  /**
   * Evaluates the state at any place.
   *
   * @param t from {@link #start} to {@link #end}, both included
   * @param y length n; overwritten
   * @throws IllegalArgumentException if {@code t} lies outside or the length is another
   * @throws IllegalStateException if the steps were not kept
   */
  public void at(double t, double[] y) {
    evaluate(t, y, NOT_ASKED);
  }

  /**
   * Evaluates the state and its derivative at any place inside a step.
   *
   * @param t from {@link #start} to {@link #end}, both included
   * @param y length n; overwritten
   * @param yDot derivative of the polynomial of the step, length n; overwritten
   * @throws IllegalArgumentException if {@code t} lies outside or a length is another
   * @throws IllegalStateException if the steps were not kept, or if there is none
   */
  public void at(double t, double[] y, double[] yDot) {
    requireLength("yDot", yDot, interval.y0().length);
    if (requireKept().count() == 0) {
      throw new IllegalStateException(
          "the solution has no step, and so no derivative; it begins and ends at t = " + start());
    }
    evaluate(t, y, yDot);
  }

  private void evaluate(double t, double[] y, double[] yDot) {
    requireLength("y", y, interval.y0().length);
    KeptSteps steps = requireKept();
    boolean inside = start() <= end() ? start() <= t && t <= end() : end() <= t && t <= start();
    if (!inside) {
      throw new IllegalArgumentException(
          "t = "
              + t
              + " lies outside of the solution, which reaches from "
              + start()
              + " to "
              + end());
    }
    int step = steps.stepAt(t);
    boolean atEnd = step < steps.count() && t == steps.end(step) && step + 1 < steps.count();
    Optional<FoundEvent> event = lastEventAt(t);
    // Behind an event the next step knows the derivative.
    boolean behind = event.isPresent() && atEnd;
    if (step < steps.count()) {
      steps.evaluate(behind ? step + 1 : step, t, y, yDot);
    }
    if (event.isPresent()) {
      event.get().copyAfter(y);
    } else if (t == start()) {
      System.arraycopy(interval.y0(), 0, y, 0, y.length);
    }
  }

  /** Returns the last event that happened at t: they are in the order of integration. */
  private Optional<FoundEvent> lastEventAt(double t) {
    double direction = end() < start() ? -1 : 1;
    int low = 0;
    int high = events.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (direction * (events.get(middle).time() - t) > 0) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low > 0 && events.get(low - 1).time() == t
        ? Optional.of(events.get(low - 1))
        : Optional.empty();
  }

  private KeptSteps requireKept() {
    return kept.orElseThrow(
        () ->
            new IllegalStateException(
                "the steps of the solution were not kept; use OdeOptions.keepSteps(true), or"
                    + " OdeOptions.output to receive states in the course of the integration"));
  }

  @Override
  public String toString() {
    return "solution from t = "
        + start()
        + " to "
        + end()
        + " ("
        + endReason
        + "), "
        + statistics.steps()
        + " steps, "
        + statistics.evaluations()
        + " evaluations, "
        + events.size()
        + " events";
  }

  static void requireLength(String what, double[] values, int length) {
    if (values.length != length) {
      throw new IllegalArgumentException(
          "the length of "
              + what
              + " is "
              + values.length
              + "; it must be "
              + length
              + ", the number of unknowns");
    }
  }

  /**
   * Returns the integration at its end, to be taken up by {@link Ode#resume} or {@link Dae#resume}.
   * A step that was cancelled is completed first, which evaluates the problem; what is then known
   * beyond {@link #end} belongs to the solution that goes on from there. For this method a solution
   * holds on to its integrator; it is to be called by one thread.
   *
   * @throws IllegalStateException if there is nothing to go on from: the integration has failed, or
   *     was cancelled while f was evaluated at the start; one cancelled in its first step has one
   */
  public OdeCheckpoint checkpoint() {
    return checkpoint.get();
  }
}
