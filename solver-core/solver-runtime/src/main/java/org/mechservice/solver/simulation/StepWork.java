package org.mechservice.solver.simulation;

import java.util.Arrays;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.simulation.equations.ModelEquations;

/**
 * The work of all forces without potential energy to about a thousandth of the energy that they add
 * and remove: enough to tell whether the balance of energy holds, at a small part of the cost of
 * {@link WorkMeter}.
 *
 * <p>The power at the ends of steps is interpolated by the cubic through the last four values and
 * integrated since the last of them. Where that differs from the parabola through the last three by
 * more than {@value #EVEN} of the turnover, as behind a jump, the step is integrated along the
 * interpolated solution by Lobatto's rule with four points, whose inner ones then follow as earlier
 * values; where the first three of these tell otherwise than all, it is halved. Loops need not be
 * closed for this: interpolated states are off by a few tolerances.
 *
 * <p>Where the two differ by less than {@value #SMOOTH} of the turnover, the power is evaluated in
 * half as many steps, down to every {@value #MOST}th, and in twice as many where they differ by
 * more than {@value #ROUGH}. The states of the steps between are kept: their powers are evaluated
 * after all, from the middle on, when the cubic over them is not even. A step that is much shorter
 * than one before ends the row of steps, and the next ones are short: something happens there. A
 * cubic over several steps sees no power that comes back in time with them; rows of steps therefore
 * differ in length.
 *
 * <p>Workspace of one run; nothing allocates in a step.
 */
final class StepWork {
  /** Values that are remembered, the last one at the end of the last step with a value. */
  private static final int KEPT = 4;

  /** Difference of two rules, relative to the turnover in the steps, that is accepted. */
  private static final double EVEN = 1e-2;

  /** The same that makes the rows of steps longer: a cubic over twice the time is off 8 times. */
  private static final double SMOOTH = 1.2e-3;

  /** The same that makes them shorter. */
  private static final double ROUGH = 5e-3;

  /** The same for the rule along the interpolated solution. */
  private static final double EVEN_INSIDE = 5e-2;

  /**
   * Part of the mean flow of energy since the start that is compared with where there is less: the
   * errors of a flow that decays as slowly as time passes add up to that of the mean.
   */
  private static final double MEAN_PART = 0.2;

  /** Most steps with one value of the power. */
  private static final int MOST = 32;

  /** Tolerance from which on a single step may hold most of what happens, and has its value. */
  private static final double COARSE = 1e-4;

  /** Length of a step, relative to the longest in its row and the one before, that ends the row. */
  private static final double SHORTER = 0.45;

  /** Most halvings of a step. */
  private static final int HALVINGS = 6;

  /** Inner points of Lobatto's rule with four points in [0, 1]. */
  private static final double INNER = 0.5 - 0.5 / Math.sqrt(5);

  /** Points of Gauss' rule with two points in [0, 1], which is exact for a cubic. */
  private static final double GAUSS = 0.5 - 0.5 / Math.sqrt(3);

  private static final PowerInput NOTHING = (t, y, power) -> {};

  private final ModelEquations equations;
  private final Integrator integrator;
  private final PowerInput source;
  private final double[] times = new double[KEPT];
  private final double[] powers = new double[KEPT];
  private final double[] earlierTimes = new double[KEPT];
  private final double[] earlierPowers = new double[KEPT];

  /** States at the ends of steps whose power is not evaluated yet, and their times. */
  private final double[][] states;

  private final double[] ends = new double[MOST];

  /** Their powers and flows, where they are evaluated after all. */
  private final boolean[] evaluatedAt = new boolean[MOST];

  private final double[] powersAt = new double[MOST];
  private final double[] flowsAt = new double[MOST];
  private final double[] y;
  private final double[] yDot;
  private final double[] evaluated = new double[2];

  /** Number of steps whose work is not known yet. */
  private int waiting;

  /** Steps with one value of the power, at most. */
  private int stride = 1;

  /** Counts rows of steps. */
  private int parity;

  /** Where the first step whose work is not known begins. */
  private double reached;

  /** Longest step of this row and of the one before, s. */
  private double longest;

  private double longestBefore;
  private int known;
  private double flow;
  private double work;
  private double turnover;
  private double turnoverBefore;
  private double start = Double.NaN;
  private double difference;

  /** Whether the work of the step before the last value is not added yet, and that step. */
  private boolean left;

  private double leftFrom;
  private double leftRate;

  /** Whether the last step has its work from the cubic. */
  private boolean even;

  /** Most steps in a row in this run. */
  private final int most;

  private StepWork(
      ModelEquations equations, Integrator integrator, PowerInput source, double tolerance) {
    this.equations = equations;
    this.integrator = integrator;
    this.source = source;
    most = tolerance < COARSE ? MOST : 1;
    y = new double[equations.dimension()];
    yDot = new double[equations.dimension()];
    states = new double[source == NOTHING ? 0 : MOST][equations.dimension()];
  }

  /**
   * Returns the work in a run of a model.
   *
   * @param wanted whether it is measured; otherwise, or if the model does no such work, it stays
   *     zero
   * @param tolerance relative tolerance of the run
   */
  static StepWork of(
      ModelEquations equations,
      Integrator integrator,
      Model model,
      boolean wanted,
      double tolerance) {
    PowerInput source = wanted && model instanceof PowerInput able ? able : NOTHING;
    return new StepWork(equations, integrator, source, tolerance);
  }

  /**
   * Takes note of the last step, and adds the work up to its end where that is due.
   *
   * @param last whether it is due in any case
   */
  void advance(boolean last) {
    double from = integrator.previousTime();
    double to = integrator.time();
    double h = to - from;
    turnoverBefore = turnover;
    if (source == NOTHING) {
      return;
    }
    boolean happens = false;
    if (h > 0) {
      if (waiting == 0) {
        reached = from;
      }
      if (Double.isNaN(start)) {
        start = from;
      }
      ends[waiting] = Math.max(from + 0.5 * h, to - equations.inset(to));
      integrator.interpolate(ends[waiting], states[waiting], yDot);
      waiting++;
      happens = h < SHORTER * Math.max(longest, longestBefore);
      longest = Math.max(longest, h);
    }
    if (waiting >= rowLength() || happens || last) {
      addWaiting();
    }
    if (happens) {
      stride = Math.min(stride, Math.min(2, most));
      longest = h;
      longestBefore = h;
    }
  }

  private int rowLength() {
    return Math.max(1, stride - (parity % 3) * stride / 8);
  }

  /** Adds the work up to the end of the last step. */
  void addWaiting() {
    if (waiting == 0) {
      return;
    }
    Arrays.fill(evaluatedAt, 0, waiting, false);
    left = false;
    addRow(0, waiting - 1);
    waiting = 0;
    parity++;
    longestBefore = longest;
    longest = 0;
  }

  /** Adds the work of some of the waiting steps: of all at once, or else of each half. */
  private void addRow(int first, int last) {
    System.arraycopy(times, 0, earlierTimes, 0, KEPT);
    System.arraycopy(powers, 0, earlierPowers, 0, KEPT);
    int knownBefore = known;
    double flowBefore = flow;
    double from = reached;
    double to = last == waiting - 1 ? integrator.time() : ends[last];
    push(last);
    double rate = 0.5 * (flowBefore + flow);
    even = addCubic(from, to, rate);
    if (even) {
      adapt(last - first + 1, (to - from) * rate);
    } else if (last > first) {
      System.arraycopy(earlierTimes, 0, times, 0, KEPT);
      System.arraycopy(earlierPowers, 0, powers, 0, KEPT);
      known = knownBefore;
      flow = flowBefore;
      int middle = (first + last) / 2;
      stride = Math.max(1, middle - first + 1);
      addRow(first, middle);
      addRow(middle + 1, last);
      return;
    }
    addLeft();
    if (!even) {
      stride = 1;
      if (last == waiting - 1) {
        addAlong(Math.max(from, integrator.previousTime()), to);
      } else {
        left = true;
        leftFrom = from;
        leftRate = rate;
      }
    }
    reached = to;
  }

  /** Adds the work of an uneven step by the cubic through values on both sides of it. */
  private void addLeft() {
    if (left) {
      left = false;
      double to = times[KEPT - 2];
      if (!addCubic(leftFrom, to, leftRate)) {
        work += 0.5 * (to - leftFrom) * (powers[KEPT - 3] + powers[KEPT - 2]);
        turnover += (to - leftFrom) * leftRate;
      }
    }
  }

  /** Adds the work of the last step along the interpolated solution. */
  private void addAlong(double from, double to) {
    double end = powers[KEPT - 1];
    double endFlow = flow;
    power(Math.min(0.5 * (from + to), from + equations.inset(from)));
    double first = evaluated[0];
    along(from, first, evaluated[1], to, end, endFlow, HALVINGS);
    flow = endFlow;
  }

  /** Adds the work between two values of the power by the cubic; returns false if it is uneven. */
  private boolean addCubic(double from, double to, double rate) {
    double h = to - from;
    double cubic = known < KEPT ? Double.NaN : h * mean(from, h, 0);
    difference = known < KEPT ? Double.NaN : Math.abs(cubic - h * mean(from, h, 1));
    if (!(difference <= EVEN * scale(h, h * rate))) {
      return false;
    }
    work += cubic;
    turnover += h * rate;
    return true;
  }

  /**
   * Returns what differences are compared with in a time, J: the turnover, or a part of the mean.
   */
  private double scale(double h, double inTime) {
    double since = integrator.time() - start;
    return Math.max(inTime, MEAN_PART * turnover * (h / since));
  }

  /** Adapts the length of rows to the last difference. */
  private void adapt(int steps, double inTime) {
    double h = times[KEPT - 1] - reached;
    double scale = scale(h, inTime);
    if (difference <= SMOOTH * scale && 2 * steps > stride) {
      stride = Math.min(2 * stride, most);
    } else if (difference > ROUGH * scale) {
      stride = Math.max(1, stride / 2);
    }
  }

  /** Evaluates the power at the end of a step. */
  private void push(int step) {
    if (!evaluatedAt[step]) {
      Arrays.fill(evaluated, 0);
      source.power(ends[step], states[step], evaluated);
      evaluatedAt[step] = true;
      powersAt[step] = evaluated[0];
      flowsAt[step] = evaluated[1];
    }
    for (int i = 1; i < KEPT; i++) {
      times[i - 1] = times[i];
      powers[i - 1] = powers[i];
    }
    times[KEPT - 1] = ends[step];
    powers[KEPT - 1] = powersAt[step];
    flow = flowsAt[step];
    known = Math.min(KEPT, known + 1);
  }

  /** Evaluates the power inside the last step. */
  private void power(double t) {
    integrator.interpolate(t, y, yDot);
    evaluated[0] = 0;
    evaluated[1] = 0;
    source.power(t, y, evaluated);
  }

  /** Returns the mean of the interpolated power over a step, without the oldest values. */
  private double mean(double from, double h, int oldest) {
    return 0.5
        * (interpolated(from + GAUSS * h, oldest) + interpolated(from + (1 - GAUSS) * h, oldest));
  }

  /** Returns the power by Lagrange's formula. */
  private double interpolated(double t, int oldest) {
    double sum = 0;
    for (int i = oldest; i < KEPT; i++) {
      double factor = powers[i];
      for (int j = oldest; j < KEPT; j++) {
        if (j != i) {
          factor *= (t - times[j]) / (times[i] - times[j]);
        }
      }
      sum += factor;
    }
    return sum;
  }

  /** Adds the work of a part of the last step by Lobatto's rule; its ends are known. */
  private void along(
      double from,
      double first,
      double firstFlow,
      double to,
      double last,
      double lastFlow,
      int more) {
    double h = to - from;
    double t1 = from + INNER * h;
    double t2 = to - INNER * h;
    power(t1);
    double p1 = evaluated[0];
    double flow1 = evaluated[1];
    power(t2);
    double p2 = evaluated[0];
    double flow2 = evaluated[1];
    double part = h / 12 * (first + 5 * (p1 + p2) + last);
    double flowPart = h / 12 * (firstFlow + 5 * (flow1 + flow2) + lastFlow);
    times[0] = from;
    powers[0] = first;
    times[1] = t1;
    powers[1] = p1;
    times[2] = t2;
    powers[2] = p2;
    times[3] = to;
    powers[3] = last;
    known = KEPT;
    double middle = 0.5 * (from + to);
    if (more == 0
        || !(middle > from && middle < to)
        || Math.abs(part - h * mean(from, h, 1)) <= EVEN_INSIDE * scale(h, flowPart)) {
      work += part;
      turnover += flowPart;
      return;
    }
    power(middle);
    double between = evaluated[0];
    double betweenFlow = evaluated[1];
    along(from, first, firstFlow, middle, between, betweenFlow, more - 1);
    along(middle, between, betweenFlow, to, last, lastFlow, more - 1);
  }

  /** Adds energy of an event, J; the power may be another behind it. */
  void add(double energy) {
    work += energy;
    turnover += Math.abs(energy);
  }

  /** Returns the work up to the end of the last step, J; NaN where it is not added yet. */
  double work() {
    return waiting > 0 ? Double.NaN : work;
  }

  /**
   * Returns the work up to a time within the last step, J; NaN where it is not added yet, or the
   * power is too uneven in the step.
   */
  double work(double t) {
    double left = integrator.time() - t;
    if (waiting > 0 || left == 0 || turnover == turnoverBefore) {
      return work();
    }
    return even ? work - left * mean(t, left, 0) : Double.NaN;
  }

  /** Returns the sum of energy added and removed so far, J. */
  double turnover() {
    return turnover;
  }

  /** Saves or restores the work. */
  void transfer(SavedState state) {
    state.numbers(times);
    state.numbers(powers);
    known = state.integer(known);
    flow = state.number(flow);
    work = state.number(work);
    turnover = state.number(turnover);
    stride = state.integer(stride);
    parity = state.integer(parity);
    reached = state.number(reached);
    start = state.number(start);
    longest = state.number(longest);
    longestBefore = state.number(longestBefore);
    waiting = state.integer(waiting);
    for (int i = 0; i < waiting; i++) {
      state.numbers(states[i]);
    }
    state.numbers(ends);
  }
}
