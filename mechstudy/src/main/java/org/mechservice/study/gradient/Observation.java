package org.mechservice.study.gradient;

import java.util.Arrays;
import org.apache.commons.math3.analysis.UnivariateFunction;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.mechservice.solver.ode.solve.SolvedStep;
import org.mechservice.study.Reduction;

/**
 * Finds where a column is least or largest, or where it first passes a level, between the steps of
 * an integration and not at its rows only.
 *
 * <p>An extreme inside the motion is a zero of the column's rate, so its derivative is that of the
 * column at a fixed time. At a corner, where an event is, the time of the event adds its part.
 */
final class Observation {
  /** Parts of a step at which the column is looked at. */
  private static final int PARTS = 4;

  private static final int MOST_EVALUATIONS = 200;

  /** Takes the derivatives of a column at a place of the motion. */
  interface Capture {
    /**
     * Returns the derivatives of a column by all directions at a fixed time; empty if they are not
     * requested.
     *
     * @param z everything that is integrated, the state first
     */
    double[] slopes(double t, double[] z, int column);
  }

  private final GradientModel model;
  private final int column;
  private final Reduction.Kind kind;
  private final double level;
  private final Capture capture;

  /** 1 for the largest, −1 for the least. */
  private final double sense;

  private final double[] z;
  private final double[] zDot;
  private final double[] both;
  private double value = Double.NaN;
  private double time = Double.NaN;
  private double[] slopes = {};
  private Side side = Side.SMOOTH;
  private boolean rising;
  private double previous = Double.NaN;

  /**
   * @param length of what is integrated
   */
  Observation(GradientModel model, int column, Reduction reduction, int length, Capture capture) {
    this.model = model;
    this.column = column;
    this.kind = reduction.kind();
    this.level = reduction.argument();
    this.capture = capture;
    sense = kind == Reduction.Kind.MIN ? -1 : 1;
    z = new double[length];
    zDot = new double[length];
    both = new double[2 * model.n];
  }

  /** Returns the extreme value, or the time of the crossing; NaN if there is none. */
  double value() {
    return kind == Reduction.Kind.CROSSING ? time : value;
  }

  /** Returns where it is, s. */
  double time() {
    return time;
  }

  /** Returns its derivatives. */
  double[] slopes() {
    return slopes;
  }

  /** Where an extreme is. */
  enum Side {
    /** At the start, at the end or between events. */
    SMOOTH,
    /** At an event, before it. */
    BEFORE,
    /** At an event, behind it. */
    BEHIND
  }

  /** Returns where it is. */
  Side side() {
    return side;
  }

  /** Takes note of the start. */
  void begin(double t, double[] start) {
    System.arraycopy(start, 0, z, 0, z.length);
    model.derivative(t, z, zDot);
    double at = observed(t);
    previous = at - level;
    if (kind == Reduction.Kind.CROSSING) {
      if (previous == 0) {
        throw new IllegalArgumentException(
            "the column is on the level " + level + " at the start: the time has no derivative");
      }
      return;
    }
    take(t, at, Side.SMOOTH);
    rising = sense * rate(t) > 0;
  }

  /** Takes note of a step. */
  void step(SolvedStep step) {
    if (kind == Reduction.Kind.CROSSING) {
      lookForCrossing(step);
      return;
    }
    double from = step.start();
    double width = (step.end() - from) / PARTS;
    double[] at = new double[PARTS + 1];
    int best = 0;
    for (int i = 0; i <= PARTS; i++) {
      at[i] = sense * observed(step, i == PARTS ? step.end() : from + i * width);
      best = at[i] > at[best] ? i : best;
    }
    if (best < PARTS && (best > 0 || rising)) {
      refine(step, from + Math.max(0, best - 1) * width, from + (best + 1) * width);
    }
    observed(step, step.end());
    rising = false;
    if (best == PARTS && at[best] > sense * value) {
      model.derivative(step.end(), z, zDot);
      rising = sense * rate(step.end()) > 0;
      if (!rising) {
        refine(step, from + (PARTS - 1) * width, step.end());
      }
    }
  }

  /**
   * Takes note of a state at an event.
   *
   * @param timeSlopes derivatives of the event's time by the directions; empty if they are not
   *     requested
   */
  void corner(double t, double[] state, double[] timeSlopes, Side where) {
    if (kind == Reduction.Kind.CROSSING) {
      System.arraycopy(state, 0, z, 0, z.length);
      model.derivative(t, z, zDot);
      previous = observed(t) - level;
      return;
    }
    System.arraycopy(state, 0, z, 0, z.length);
    model.derivative(t, z, zDot);
    double here = observed(t);
    double speed = rate(t);
    rising = sense * speed > 0;
    if (sense * here > sense * value) {
      take(t, here, where);
      for (int k = 0; k < slopes.length && k < timeSlopes.length; k++) {
        slopes[k] += speed * timeSlopes[k];
      }
    }
  }

  /** Takes note of the end of the run. */
  void end(double t, double[] state) {
    if (kind == Reduction.Kind.CROSSING) {
      return;
    }
    System.arraycopy(state, 0, z, 0, z.length);
    model.derivative(t, z, zDot);
    double here = observed(t);
    if (sense * here > sense * value) {
      take(t, here, Side.SMOOTH);
    }
  }

  private void take(double t, double found, Side where) {
    value = found;
    time = t;
    side = where;
    slopes = capture.slopes(t, z, column);
  }

  private double observed(SolvedStep step, double t) {
    step.at(t, z, zDot);
    return observed(t);
  }

  private double observed(double t) {
    System.arraycopy(z, 0, both, 0, model.n);
    System.arraycopy(zDot, 0, both, model.n, model.n);
    return model.columns(t, both)[column];
  }

  /** Returns the rate of the column at the state and rate at hand. */
  private double rate(double t) {
    System.arraycopy(z, 0, both, 0, model.n);
    System.arraycopy(zDot, 0, both, model.n, model.n);
    return model.columnRates(t, both)[column];
  }

  private void refine(SolvedStep step, double from, double to) {
    UnivariateFunction rate =
        t -> {
          step.at(t, z, zDot);
          model.derivative(t, z, zDot);
          return sense * rate(t);
        };
    double t = zero(rate, from, to);
    if (Double.isNaN(t)) {
      return;
    }
    step.at(t, z, zDot);
    model.derivative(t, z, zDot);
    double here = observed(t);
    if (sense * here > sense * value) {
      take(t, here, Side.SMOOTH);
    }
  }

  private static double zero(UnivariateFunction function, double from, double to) {
    double first = function.value(from);
    double last = function.value(to);
    if (first == 0) {
      return from;
    } else if (last == 0) {
      return to;
    } else if (first * last > 0 || from == to) {
      return Double.NaN;
    }
    double accuracy = 1e-15 * Math.max(Math.abs(from), Math.abs(to));
    return new BrentSolver(1e-15, Math.max(accuracy, Double.MIN_NORMAL), 0)
        .solve(MOST_EVALUATIONS, function, from, to);
  }

  private void lookForCrossing(SolvedStep step) {
    double width = (step.end() - step.start()) / PARTS;
    for (int i = 1; i <= PARTS && Double.isNaN(time); i++) {
      double to = i == PARTS ? step.end() : step.start() + i * width;
      double here = observed(step, to) - level;
      if (here * previous <= 0) {
        double t = zero(place -> observed(step, place) - level, step.start() + (i - 1) * width, to);
        double found = Double.isNaN(t) ? to : t;
        step.at(found, z, zDot);
        model.derivative(found, z, zDot);
        double speed = rate(found);
        take(found, level, Side.SMOOTH);
        slopes = Arrays.stream(slopes).map(slope -> -slope / speed).toArray();
      }
      previous = here;
    }
  }
}
