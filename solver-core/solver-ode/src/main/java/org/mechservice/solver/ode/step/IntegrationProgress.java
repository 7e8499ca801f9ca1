package org.mechservice.solver.ode.step;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;

/**
 * The progress of an integration: its time, the steps it has tried, and the reason why it cannot
 * continue.
 */
public final class IntegrationProgress {
  /** Tries in a row with values that are not finite before the integrator gives up. */
  private static final int NOT_FINITE_TRIES = 10;

  /**
   * The same without a step between them that gets on: towards a place that cannot be passed, steps
   * are halved some fifty times; then they could creep on by the last digit of t.
   */
  private static final int NOT_FINITE_TRIES_AT_ONE_PLACE = 100;

  /** Tries after which is looked whether the end can be reached, a power of two. */
  private static final long LOOK = 1 << 20;

  /** Number of steps that would take days to months. */
  private static final double ENDLESS = 1e11;

  private final RecentSteps recentSteps = new RecentSteps();
  private final RejectionCounts limits = new RejectionCounts();
  private Optional<IntegrationFailure> failure = Optional.empty();
  private boolean running;

  /** End, start, size and order of the last accepted step. */
  private double time;

  private double previousTime;
  private double stepSize;
  private int order;

  /** Start, and end of the last step that was longer than places on the t axis are uncertain. */
  private double start;

  private double resolution;
  private double resolvedTime;

  private int notFiniteInARow;
  private int notFiniteHere;
  private long steps;
  private long rejectedSteps;

  /**
   * Begins a problem that is not yet ready to be advanced.
   *
   * @param dimension of the problem
   * @param relativeTolerance to which a place on the t axis is known, relative to the time elapsed
   */
  public void begin(double t0, int dimension, double relativeTolerance) {
    limits.begin(dimension);
    start = t0;
    resolution = relativeTolerance;
    resolvedTime = t0;
    recentSteps.clear();
    failure = Optional.empty();
    running = false;
    time = t0;
    previousTime = t0;
    stepSize = 0;
    order = 0;
    notFiniteInARow = 0;
    notFiniteHere = 0;
    steps = 0;
    rejectedSteps = 0;
  }

  /** Goes back to a place inside the last step, from where there is no history; counters go on. */
  public void beginAgain(double t) {
    failure = Optional.empty();
    running = false;
    time = t;
    previousTime = t;
    resolvedTime = t;
    stepSize = 0;
    order = 0;
    notFiniteInARow = 0;
    notFiniteHere = 0;
  }

  /** Makes the problem ready unless its end is reached; returns the result of the step so far. */
  public StepResult goOn(boolean endReached) {
    running = !endReached;
    return running ? StepResult.ADVANCED : StepResult.REACHED_END;
  }

  /** Takes note of an accepted step. */
  public void accepted(double h, double end, int order, double error) {
    recentSteps.record(time, h, order, error, TrialOutcome.PASSED);
    previousTime = time;
    time = end;
    if (Math.abs(h) >= resolution * Math.abs(end - start)) {
      resolvedTime = end;
      notFiniteHere = 0;
    }
    stepSize = h;
    this.order = order;
    notFiniteInARow = 0;
    steps++;
  }

  /**
   * Takes note of a rejected step.
   *
   * @param component that it failed by; −1 if none can be named
   */
  public void rejected(double h, int order, double error, TrialOutcome attempt, int component) {
    limits.rejected(attempt, component);
    recentSteps.record(time, h, order, error, attempt);
    notFiniteInARow = attempt == TrialOutcome.NOT_FINITE ? notFiniteInARow + 1 : 0;
    notFiniteHere += attempt == TrialOutcome.NOT_FINITE ? 1 : 0;
    rejectedSteps++;
  }

  /** Returns whether so many tries were not finite that shorter steps will not help. */
  public boolean notFiniteTooOften() {
    return notFiniteInARow >= NOT_FINITE_TRIES || notFiniteHere >= NOT_FINITE_TRIES_AT_ONE_PLACE;
  }

  /** Ends the integration; for the arguments see {@link IntegrationFailure}. */
  public StepResult fail(Cause cause, double h, int order, int component, ErrorNorm norm) {
    running = false;
    double allowed = component < 0 ? 0 : 1 / norm.weight(component);
    double where = cause == Cause.STEP_TOO_SMALL ? resolvedTime : time;
    failure =
        Optional.of(
            new IntegrationFailure(
                cause, where, h, h == 0 ? 0 : order, component, allowed, recentSteps.list()));
    return StepResult.FAILED;
  }

  /** Returns where the problem began. */
  public double start() {
    return start;
  }

  /** Returns the result of the last step, of an integration that has not failed. */
  public StepResult result() {
    return running ? StepResult.ADVANCED : StepResult.REACHED_END;
  }

  /**
   * Requires a place from which an integration can be saved.
   *
   * @param withinStep whether a step was begun and stopped
   */
  public void requireBetweenSteps(boolean withinStep) {
    if (withinStep || failure.isPresent() || (!running && steps == 0)) {
      throw new IllegalStateException("only an integration between two steps can be saved");
    }
  }

  public void requireRunning() {
    if (!running) {
      throw new IllegalStateException(
          failure.isPresent()
              ? "the integration failed at t = " + time + "; start a new one"
              : "nothing to integrate: the end is reached, or start was not called");
    }
  }

  public void requireInLastStep(double t) {
    if (!((previousTime <= t && t <= time) || (time <= t && t <= previousTime))) {
      throw new IllegalArgumentException(
          "t = " + t + " lies outside the last step, " + previousTime + " to " + time);
    }
  }

  /** Requires an accepted step that the history belongs to. */
  public void requireStep() {
    if (order == 0) {
      throw new IllegalStateException("no step was taken since the start or the last restart");
    }
  }

  public double time() {
    return time;
  }

  public double previousTime() {
    return previousTime;
  }

  public double stepSize() {
    return stepSize;
  }

  public int order() {
    return order;
  }

  public long steps() {
    return steps;
  }

  public long rejectedSteps() {
    return rejectedSteps;
  }

  /** Returns which components made steps be rejected. */
  public List<IntegrationStatistics.Limit> limits() {
    return limits.list();
  }

  /**
   * Returns whether another step may be tried: not after as many as are allowed, and not when after
   * a million of them neither their mean nor the last one is long enough to come to the end.
   *
   * @param end of the problem
   */
  public boolean mayTry(long allowed, double end) {
    long tries = steps + rejectedSteps;
    if (tries == 0 || (tries & (LOOK - 1)) != 0) {
      return tries < allowed;
    }
    double way = Math.max(Math.abs(stepSize), Math.abs(time - start) / tries);
    return tries < allowed && Math.abs(end - time) <= ENDLESS * way;
  }

  public IntegrationFailure failure() {
    return failure.orElseThrow(() -> new IllegalStateException("the integration has not failed"));
  }

  /** Carries the state between two steps over. */
  public void transfer(SavedState state) {
    recentSteps.transfer(state);
    limits.transfer(state);
    running = state.flag(running);
    start = state.number(start);
    time = state.number(time);
    previousTime = state.number(previousTime);
    resolvedTime = state.number(resolvedTime);
    stepSize = state.number(stepSize);
    order = state.integer(order);
    notFiniteInARow = state.integer(notFiniteInARow);
    notFiniteHere = state.integer(notFiniteHere);
    steps = state.integer(steps);
    rejectedSteps = state.integer(rejectedSteps);
  }
}
