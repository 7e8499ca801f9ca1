package org.mechservice.report.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Integrates a state through given times and events by the steps of a code. A zero that ends a
 * phase is located by varying the length of a step of the code itself, without dense output, so
 * that the state there is as accurate as at the end of any other step.
 */
final class PhaseIntegration {
  private static final double SMALLEST_STEP = 1e-13;

  /** Final width of the bracket around a zero, in units in the last place of time. */
  private static final double BRACKET = 4;

  /** First step of a phase as a part of the phase before: the next may be as short. */
  private static final double FIRST_STEP = 0.05;

  /** One step of a code. */
  interface Steps {
    /**
     * Starts at a new point; the equations may have changed.
     *
     * @return false if they have no value there
     */
    default boolean begin(double t) {
      return true;
    }

    /** Tries a step; returns its weighted error, infinite if there is none. */
    double attempt(double t, double step);

    /** Returns the change of the state in the last attempted step. Not to be modified. */
    double[] increment();

    /**
     * Renews the Jacobian or the factors that the last step may have failed with.
     *
     * @return false if there was nothing to renew
     */
    default boolean renew(double t) {
      return false;
    }

    /** Returns the length to try after a step with an error. */
    double next(double step, double error, boolean accepted);
  }

  private final Problem problem;
  private final Phases phases;
  private final CompensatedState state;
  private final ZeroCrossings passages;
  private final Steps steps;
  private final double tolerance;
  private final long deadline;
  private final double longestStep;
  private double h;
  private double end;
  private double began;

  PhaseIntegration(
      Problem problem, CompensatedState state, Steps steps, double tolerance, long deadline) {
    this.problem = problem;
    phases = problem.phases();
    this.state = state;
    passages = new ZeroCrossings(problem, phases);
    this.steps = steps;
    this.tolerance = tolerance;
    this.deadline = deadline;
    longestStep = Math.min(problem.longestStep(), phases.longestStep());
  }

  /**
   * Returns the states at times, the first of which is now.
   *
   * @param firstStep to try
   * @return fewer states if the solution ends before, or the deadline passes and the problem takes
   *     a part of its interval; empty if it cannot be found
   */
  Optional<double[][]> through(double[] times, double firstStep) {
    h = Math.min(firstStep, longestStep);
    end = times[times.length - 1];
    began = times[0];
    List<double[]> states = new ArrayList<>(List.of(state.y.clone()));
    double t = times[0];
    if (!passages.begin(t, state.y, end - t)) {
      return Optional.empty();
    }
    for (int k = 1; k < times.length; k++) {
      while (t < times[k]) {
        double to = Math.min(times[k], phases.nextBreak(t));
        Reached reached = steps.begin(t) ? advance(t, to) : Reached.NOWHERE;
        if (Double.isNaN(reached.t())) {
          boolean late = System.nanoTime() > deadline && states.size() >= problem.fewestTimes();
          return late ? Optional.of(states.toArray(double[][]::new)) : Optional.empty();
        }
        if (reached.ended()) {
          return Optional.of(states.toArray(double[][]::new));
        }
        t = reached.t();
      }
      states.add(state.y.clone());
    }
    return Optional.of(states.toArray(double[][]::new));
  }

  private record Reached(double t, boolean ended) {
    static final Reached NOWHERE = new Reached(Double.NaN, false);
  }

  /** Steps of equal size to a time, as far as the error allows, or to the end of the phase. */
  private Reached advance(double from, double to) {
    double t = from;
    double smallest = SMALLEST_STEP * Math.max(Math.abs(to), to - from);
    while (t < to) {
      double left = to - t;
      double step = CompensatedState.equalStep(left, Math.min(h, longestStep));
      boolean last = step >= left * (1 - 1e-12);
      if ((step < smallest && !last) || System.nanoTime() > deadline) {
        return Reached.NOWHERE;
      }
      double error = steps.attempt(t, step);
      if (error <= tolerance) {
        double behind = last ? to : t + step;
        double[] g = new double[phases.count()];
        if (!valuesAt(behind, g)) {
          return Reached.NOWHERE;
        }
        if (passages.anyPassed(g)) {
          return locate(t, behind, g);
        }
        t = behind;
        passages.moveTo(g);
        if (!settle(t)) {
          return Reached.NOWHERE;
        }
        h = steps.next(step, error, true);
      } else if (!Double.isInfinite(error) || !steps.renew(t)) {
        h = steps.next(step, error, false);
      }
    }
    return to < phases.nextBreak(from) ? new Reached(to, false) : beginPhase(to);
  }

  private boolean settle(double t) {
    state.add(steps.increment());
    return state.settle(problem, t);
  }

  /** The functions at the end of the step tried last. */
  private boolean valuesAt(double t, double[] g) {
    if (g.length == 0) {
      return true;
    }
    double[] y = state.y.clone();
    double[] increment = steps.increment();
    for (int k = 0; k < y.length; k++) {
      y[k] += increment[k];
    }
    return phases.values(t, y, g);
  }

  /**
   * Shortens a step to the first zero that ends the phase, by the rule of false position in the
   * Illinois form, and by halves where that is slow; then ends the phase there.
   */
  private Reached locate(double t, double end, double[] gEnd) {
    double before = t;
    double behind = end;
    double[] gBefore = passages.here().clone();
    double[] gBehind = gEnd;
    double weightBefore = 1;
    double weightBehind = 1;
    int slow = 0;
    double width = BRACKET * Math.max(Math.ulp(t), Math.ulp(end));
    while (behind - before > width) {
      double length = behind - before;
      double part = slow < 2 ? firstZero(gBefore, weightBefore, gBehind, weightBehind) : 0.5;
      double inside = Math.min(0.5, 0.5 * width / length);
      double middle = before + length * Math.max(inside, Math.min(1 - inside, part));
      double[] g = new double[gEnd.length];
      if (middle <= before || middle >= behind) {
        break;
      }
      if (!succeeds(t, middle - t) || !valuesAt(middle, g)) {
        return Reached.NOWHERE;
      }
      if (passages.anyPassed(g)) {
        behind = middle;
        gBehind = g;
        weightBehind = 1;
        weightBefore *= 0.5;
      } else {
        before = middle;
        gBefore = g;
        weightBefore = 1;
        weightBehind *= 0.5;
      }
      slow = behind - before > 0.5 * length ? slow + 1 : 0;
    }
    boolean[] passed = passages.allPassed(gBehind);
    passages.located(gBefore, gBehind);
    if (!succeeds(t, behind - t) || !settle(behind)) {
      return Reached.NOWHERE;
    }
    double[] y = state.y.clone();
    if (!phases.change(passed, behind, y)) {
      return new Reached(behind, true);
    }
    state.set(y);
    return beginPhase(behind);
  }

  /** Returns whether a step not longer than a successful one also succeeds. */
  private boolean succeeds(double t, double step) {
    double error = steps.attempt(t, step);
    if (Double.isInfinite(error) && steps.renew(t)) {
      error = steps.attempt(t, step);
    }
    return error <= tolerance;
  }

  /** Where the first of the functions that have passed is zero on a straight line, from 0 to 1. */
  private double firstZero(
      double[] before, double weightBefore, double[] behind, double weightBehind) {
    double first = 1;
    for (int i = 0; i < behind.length; i++) {
      if (passages.passed(i, behind[i])) {
        double from = weightBefore * before[i];
        double to = weightBehind * behind[i];
        first = Math.min(first, from / (from - to));
      }
    }
    return first;
  }

  private Reached beginPhase(double t) {
    phases.continueFrom(t);
    h = Math.min(h, FIRST_STEP * (t - began));
    began = t;
    boolean goes = state.settle(problem, t) && passages.begin(t, state.y, end - t);
    return goes ? new Reached(t, false) : Reached.NOWHERE;
  }
}
