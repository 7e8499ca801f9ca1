package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.ode.solve.EndReason;
import org.mechservice.solver.ode.solve.FoundEvent;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.solver.ode.solve.OdeSolution;
import org.mechservice.study.Reduction;

/**
 * One integration of the state together with its tangents along all directions; the error of each
 * is held below the tolerances. The vector is [y; S_1 .. S_p; W; w_1 .. w_p] with W the integrals
 * of columns and w their tangents, and a marker if there are switches.
 */
final class ForwardRun {
  private final GradientModel model;
  private final List<GradientOutput> wanted;
  private final MotionProblem motion;
  private final int n;
  private final int p;
  private final int integrals;
  private final int length;
  private final int[] integralOf;
  private final double[] zDot;
  private final double[] both;
  private final double[] seeds;
  private final double[] rates;
  private final double[] slopes;
  private final List<Observation> found = new ArrayList<>();

  ForwardRun(GradientModel model, List<GradientOutput> wanted, RunSettings run) {
    this.model = model;
    this.wanted = wanted;
    n = model.n;
    p = model.p;
    integralOf = new int[wanted.size()];
    int count = 0;
    for (int i = 0; i < wanted.size(); i++) {
      integralOf[i] = wanted.get(i).isIntegral() ? count++ : -1;
    }
    integrals = count;
    both = new double[2 * n];
    seeds = new double[p * n];
    rates = new double[p * n];
    slopes = new double[model.c * (p + 1)];
    motion = new MotionProblem(model, run, this::change);
    length = (n + integrals) * (p + 1) + motion.markers();
    zDot = new double[length];
  }

  /** Returns where the integrals begin. */
  private int integralAt() {
    return n * (p + 1);
  }

  private int markerAt() {
    return (n + integrals) * (p + 1);
  }

  /** Runs from a start. */
  Outcomes run(double[] start) {
    model.prepareTangents();
    double[] z0 = new double[length];
    System.arraycopy(start, 0, z0, 0, n);
    for (int k = 0; k < p; k++) {
      System.arraycopy(model.directions.get(k).start(), 0, z0, n * (k + 1), n);
    }
    double[] values = new double[wanted.size()];
    double[][] derivatives = new double[wanted.size()][p];
    OdeOptions options = motion.watched(motion.options(tolerances()));
    options = withTimes(options, values, derivatives);
    for (int i = 0; i < wanted.size(); i++) {
      if (wanted.get(i).isFound()) {
        Observation one =
            new Observation(
                model, wanted.get(i).column(), wanted.get(i).reduction(), length, this::slopesAt);
        one.begin(motion.run.tStart(), z0);
        found.add(one);
        options = options.onStep(one::step);
      }
    }
    OdeProblem problem = motion.problem(length, this::derivative);
    if (motion.method() == OdeMethod.ODE15S) {
      problem = problem.withBlocks(n).withJacobian(this::jacobian);
    }
    OdeSolution solution = Ode.solve(problem, motion.run.tStart(), z0, motion.run.tEnd(), options);
    finish(solution, values, derivatives);
    return new Outcomes(values, derivatives, solution.statistics().steps());
  }

  private OdeOptions withTimes(OdeOptions options, double[] values, double[][] derivatives) {
    double[] times =
        wanted.stream()
            .filter(w -> w.kind() == Reduction.Kind.AT)
            .mapToDouble(w -> w.reduction().argument())
            .sorted()
            .distinct()
            .toArray();
    Arrays.fill(values, Double.NaN);
    if (times.length == 0) {
      return options;
    }
    Map<Double, List<Integer>> at = new HashMap<>();
    for (int i = 0; i < wanted.size(); i++) {
      if (wanted.get(i).kind() == Reduction.Kind.AT) {
        at.computeIfAbsent(wanted.get(i).reduction().argument(), t -> new ArrayList<>()).add(i);
      }
    }
    return options.output(
        times,
        (t, z) -> {
          observe(t, z);
          for (int i : at.getOrDefault(t, List.of())) {
            take(i, values, derivatives);
          }
        });
  }

  private void take(int i, double[] values, double[][] derivatives) {
    int column = wanted.get(i).column();
    values[i] = slopes[column];
    for (int k = 0; k < p; k++) {
      derivatives[i][k] = slopes[(k + 1) * model.c + column];
    }
  }

  private double[] tolerances() {
    double[] ofState = motion.tolerances();
    double[] tolerances = new double[length];
    System.arraycopy(ofState, 0, tolerances, 0, n);
    double ofIntegrals =
        motion.run.absoluteTolerance() * Math.max(1e-3, motion.run.tEnd() - motion.run.tStart());
    Arrays.fill(tolerances, integralAt(), length, ofIntegrals);
    for (int k = 0; k < p; k++) {
      double size = model.directions.get(k).size();
      for (int i = 0; i < n; i++) {
        tolerances[n * (k + 1) + i] = ofState[i] / size;
      }
      for (int i = 0; i < integrals; i++) {
        tolerances[integralAt() + integrals * (k + 1) + i] = ofIntegrals / size;
      }
    }
    Arrays.fill(tolerances, markerAt(), length, motion.markerTolerance());
    return tolerances;
  }

  private void derivative(double t, double[] z, double[] out) {
    System.arraycopy(z, n, seeds, 0, p * n);
    model.tangents(t, z, seeds, out);
    if (length > markerAt()) {
      out[markerAt()] = motion.markerRate(t, z);
    }
    if (integrals > 0) {
      columnsOf(t, z, out);
      for (int i = 0; i < wanted.size(); i++) {
        if (integralOf[i] >= 0) {
          GradientOutput one = wanted.get(i);
          double value = slopes[one.column()];
          int at = integralAt() + integralOf[i];
          out[at] = one.integrand(value);
          double slope = one.integrandSlope(value);
          for (int k = 0; k < p; k++) {
            out[at + integrals * (k + 1)] = slope * slopes[(k + 1) * model.c + one.column()];
          }
        }
      }
    }
  }

  private void columnsOf(double t, double[] z, double[] rate) {
    System.arraycopy(z, 0, both, 0, n);
    System.arraycopy(rate, 0, both, n, n);
    System.arraycopy(rate, n, rates, 0, p * n);
    System.arraycopy(z, n, seeds, 0, p * n);
    model.columnTangents(t, both, seeds, rates, slopes);
  }

  /** Evaluates the columns with their derivatives at a place of the motion. */
  private void observe(double t, double[] z) {
    if (model.columnsUseRates) {
      System.arraycopy(z, n, seeds, 0, p * n);
      model.tangents(t, z, seeds, zDot);
    }
    columnsOf(t, z, zDot);
  }

  private double[] slopesAt(double t, double[] z, int column) {
    observe(t, z);
    double[] own = new double[p];
    for (int k = 0; k < p; k++) {
      own[k] = slopes[(k + 1) * model.c + column];
    }
    return own;
  }

  /**
   * The Jacobian that stiff methods solve with: that of the state for each of the tangents. What is
   * left out couples the tangents to the state, and the iteration adds it.
   */
  private void jacobian(double t, double[] z, double[] fy) {
    double[] seed = new double[n + 1 + model.inputCount];
    double[] out = new double[2 * n];
    for (int j = 0; j < n; j++) {
      seed[j] = 1;
      model.equations.tangent(t, z, seed, out);
      seed[j] = 0;
      for (int k = 0; k <= p; k++) {
        for (int i = 0; i < n; i++) {
          fy[(k * n + i) * n + j] = out[n + i];
        }
      }
    }
  }

  /** Carries everything across a transition. */
  private void change(Transition transition, double t, double[] z) {
    Transition.Sides sides = transition.sides(t, z);
    double[] dt = timeSlopes(transition, t, sides, z);
    for (Observation one : found) {
      one.corner(t, z, dt, Observation.Side.BEFORE);
    }
    double[] before = integrands(t, z, sides.rateBefore());
    for (int k = 0; k < p; k++) {
      double[] tangent = Arrays.copyOfRange(z, n * (k + 1), n * (k + 2));
      transition.carry(t, sides, tangent, dt[k], k);
      System.arraycopy(tangent, 0, z, n * (k + 1), n);
    }
    System.arraycopy(sides.after(), 0, z, 0, n);
    double[] after = integrands(t, z, sides.rateAfter());
    for (int i = 0; i < integrals && !transition.isCorner(); i++) {
      for (int k = 0; k < p; k++) {
        z[integralAt() + integrals * (k + 1) + i] += (before[i] - after[i]) * dt[k];
      }
    }
    for (Observation one : found) {
      one.corner(t, z, dt, Observation.Side.BEHIND);
    }
  }

  private double[] timeSlopes(Transition transition, double t, Transition.Sides sides, double[] z) {
    double[] dt = new double[p];
    for (int k = 0; k < p; k++) {
      double[] tangent = Arrays.copyOfRange(z, n * (k + 1), n * (k + 2));
      dt[k] = transition.timeRate(t, sides, tangent, k);
    }
    return dt;
  }

  /** Returns what is integrated, at a state and its derivative. */
  private double[] integrands(double t, double[] z, double[] rate) {
    System.arraycopy(z, 0, both, 0, n);
    System.arraycopy(rate, 0, both, n, n);
    double[] columns = model.columns(t, both);
    double[] values = new double[integrals];
    for (int i = 0; i < wanted.size(); i++) {
      if (integralOf[i] >= 0) {
        values[integralOf[i]] = wanted.get(i).integrand(columns[wanted.get(i).column()]);
      }
    }
    return values;
  }

  private void finish(OdeSolution solution, double[] values, double[][] derivatives) {
    double[] z = solution.endState();
    double end = solution.end();
    double[] dt = new double[p];
    double[] speeds = new double[model.c];
    if (solution.endReason() == EndReason.EVENT) {
      FoundEvent last = solution.events().get(solution.events().size() - 1);
      Transition stop = motion.transitions.get(last.index());
      Transition.Sides sides = stop.sides(end, z);
      dt = timeSlopes(stop, end, sides, z);
      observe(end, z);
      System.arraycopy(z, 0, both, 0, n);
      System.arraycopy(sides.rateBefore(), 0, both, n, n);
      speeds = model.columnRates(end, both.clone());
      for (Observation one : found) {
        one.corner(end, z, dt, Observation.Side.BEFORE);
      }
    } else {
      for (Observation one : found) {
        one.end(end, z);
      }
    }
    observe(end, z);
    double[] endRate = new double[n];
    model.derivative(end, z, endRate);
    double[] integrand = integrands(end, z, endRate);
    double time = end - motion.run.tStart();
    int next = 0;
    for (int i = 0; i < wanted.size(); i++) {
      GradientOutput one = wanted.get(i);
      if (one.kind() == Reduction.Kind.LAST) {
        take(i, values, derivatives);
        for (int k = 0; k < p; k++) {
          derivatives[i][k] += speeds[one.column()] * dt[k];
        }
      } else if (one.isIntegral()) {
        int at = integralAt() + integralOf[i];
        double integral = z[at];
        values[i] = one.ofIntegral(integral, time);
        for (int k = 0; k < p; k++) {
          double slope = z[at + integrals * (k + 1)] + integrand[integralOf[i]] * dt[k];
          derivatives[i][k] =
              one.byIntegral(integral, time) * slope + one.byLength(integral, time) * dt[k];
        }
      } else if (one.isFound()) {
        Observation its = found.get(next++);
        values[i] = its.value();
        derivatives[i] = Double.isNaN(its.value()) ? filled(p) : Arrays.copyOf(its.slopes(), p);
      }
    }
  }

  private static double[] filled(int count) {
    double[] none = new double[count];
    Arrays.fill(none, Double.NaN);
    return none;
  }
}
