package org.mechservice.solver.simulation;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.simulation.equations.ModelEquations;

/**
 * The work of all forces without potential energy to about a thousandth of the energy that they add
 * and remove, with one evaluation of their power in a step: enough to tell whether the balance of
 * energy holds, at a part of the cost of {@link WorkMeter}.
 *
 * <p>The power at the ends of steps is interpolated by the cubic through the last four of them and
 * integrated over the last step. Where that differs from the parabola through the last three by
 * more than {@value #EVEN} of the turnover, as behind a jump, the step is integrated along the
 * interpolated solution by Lobatto's rule with four points, whose inner ones then follow as earlier
 * values; where the first three of these tell otherwise than all, it is halved. Loops need not be
 * closed for this: interpolated states are off by a few tolerances.
 *
 * <p>Workspace of one run; nothing allocates in a step.
 */
final class StepWork {
  /** Values that are remembered, the last one at the end of the last step. */
  private static final int KEPT = 4;

  /** Difference of two rules, relative to the turnover in the step, that is accepted. */
  private static final double EVEN = 5e-3;

  /** The same for the rule along the interpolated solution. */
  private static final double EVEN_INSIDE = 5e-2;

  /** Most halvings of a step. */
  private static final int HALVINGS = 6;

  /** Inner points of Lobatto's rule with four points in [0, 1]. */
  private static final double INNER = 0.5 - 0.5 / Math.sqrt(5);

  /** Points of Gauss' rule with two points in [0, 1], which is exact for a cubic. */
  private static final double GAUSS = 0.5 - 0.5 / Math.sqrt(3);

  /** Units in the last place of time around a jump. */
  private static final double BESIDE_JUMPS = 8;

  private static final PowerInput NOTHING = (t, y, power) -> {};

  private final ModelEquations equations;
  private final Integrator integrator;
  private final PowerInput source;
  private final double[] times = new double[KEPT];
  private final double[] powers = new double[KEPT];
  private final double[] y;
  private final double[] yDot;
  private final double[] evaluated = new double[2];
  private int known;
  private double flow;
  private double work;
  private double turnover;
  private double turnoverBefore;

  /** Whether the last step has its work from the cubic. */
  private boolean even;

  private StepWork(ModelEquations equations, Integrator integrator, PowerInput source) {
    this.equations = equations;
    this.integrator = integrator;
    this.source = source;
    y = new double[equations.dimension()];
    yDot = new double[equations.dimension()];
  }

  /** Returns the work in a run of a model. */
  static StepWork of(ModelEquations equations, Integrator integrator, Model model) {
    PowerInput source = model instanceof PowerInput able ? able : NOTHING;
    return new StepWork(equations, integrator, source);
  }

  /** Returns whether the model can do such work. */
  boolean measures() {
    return source != NOTHING;
  }

  /**
   * Adds the work of the last step.
   *
   * @param state state at its end; not modified
   */
  void advance(double[] state) {
    double from = integrator.previousTime();
    double to = integrator.time();
    double h = to - from;
    turnoverBefore = turnover;
    if (source == NOTHING || !(h > 0)) {
      return;
    }
    double flowBefore = flow;
    push(to - inset(to), state);
    double rate = 0.5 * (flowBefore + flow);
    double cubic = known < KEPT ? Double.NaN : h * mean(from, h, 0);
    double parabola = known < KEPT ? Double.NaN : h * mean(from, h, 1);
    if (Math.abs(cubic - parabola) <= EVEN * h * rate) {
      work += cubic;
      turnover += h * rate;
      even = true;
      return;
    }
    even = false;
    double last = powers[KEPT - 1];
    double lastFlow = flow;
    power(from + inset(from));
    double first = evaluated[0];
    along(from, first, evaluated[1], to, last, lastFlow, HALVINGS);
    flow = lastFlow;
  }

  private double inset(double t) {
    return equations.breakpoints().isEmpty() ? 0 : BESIDE_JUMPS * Math.ulp(t);
  }

  private void push(double t, double[] state) {
    evaluated[0] = 0;
    evaluated[1] = 0;
    source.power(t, state, evaluated);
    push(t, evaluated[0]);
    flow = evaluated[1];
  }

  private void push(double t, double power) {
    for (int i = 1; i < KEPT; i++) {
      times[i - 1] = times[i];
      powers[i - 1] = powers[i];
    }
    times[KEPT - 1] = t;
    powers[KEPT - 1] = power;
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
        || Math.abs(part - h * mean(from, h, 1)) <= EVEN_INSIDE * flowPart) {
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

  /** Returns the work up to the end of the last step, J; positive into the mechanism. */
  double work() {
    return work;
  }

  /**
   * Returns the work up to a time within the last step, J; NaN where the power is too uneven in it.
   */
  double work(double t) {
    double left = integrator.time() - t;
    if (left == 0 || turnover == turnoverBefore) {
      return work;
    }
    return even ? work - left * mean(t, left, 0) : Double.NaN;
  }

  /** Returns the sum of added and removed energy up to then, J. */
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
  }
}
