package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.ode.solve.FoundEvent;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.study.Reduction;

/**
 * The motion, and then for each number its derivatives by the state, λ, backwards in time: λ' =
 * −f_yᵀ λ − c g_y with c the weight of the column g in the number's integral. The derivatives by
 * the parameters are integrals of λᵀ f_p + c g_p, and λ at the start gives those by start values
 * (Cao, Li, Petzold and Serban 2003). Values that are taken at one time add c g_y there.
 */
final class AdjointRun {
  /** Tolerance of λ in parts of what the tolerances of the state are worth. */
  private static final double SHARE = 0.1;

  private static final double[] NONE = {};

  /** Places of the motion, last first, at which scales are taken. */
  private static final int PLACES = 64;

  private final GradientModel model;
  private final List<GradientOutput> wanted;
  private final MotionProblem motion;
  private final long memory;
  private final int n;
  private final int p;
  private final int[] integralOf;
  private final int integrals;
  private final int length;
  private final double[] both;
  private final double[] rate;
  private final double[] weights;
  private final double[] y;
  private final double[] byBoth;
  private final List<Observation> found = new ArrayList<>();

  AdjointRun(GradientModel model, List<GradientOutput> wanted, RunSettings run, long memory) {
    this.model = model;
    this.wanted = wanted;
    this.memory = memory;
    n = model.n;
    p = model.p;
    integralOf = new int[wanted.size()];
    int count = 0;
    for (int i = 0; i < wanted.size(); i++) {
      integralOf[i] = wanted.get(i).isIntegral() ? count++ : -1;
    }
    integrals = count;
    both = new double[2 * n];
    rate = new double[n];
    weights = new double[n];
    byBoth = new double[2 * n];
    motion =
        new MotionProblem(
            model,
            run,
            (transition, t, z) -> {
              Transition.Sides sides = transition.sides(t, z);
              for (Observation one : found) {
                one.corner(t, z, NONE, Observation.Side.BEFORE);
              }
              System.arraycopy(sides.after(), 0, z, 0, n);
              for (Observation one : found) {
                one.corner(t, z, NONE, Observation.Side.BEHIND);
              }
            });
    length = n + integrals + motion.markers();
    y = new double[length];
  }

  /** Runs from a start. */
  Outcomes run(double[] start) {
    double t0 = motion.run.tStart();
    double[] z0 = Arrays.copyOf(start, length);
    OdeOptions options = motion.watched(motion.options(tolerances()));
    for (GradientOutput one : wanted) {
      if (one.isFound()) {
        Observation its =
            new Observation(model, one.column(), one.reduction(), length, (t, z, column) -> NONE);
        its.begin(t0, z0);
        found.add(its);
        options = options.onStep(its::step);
      }
    }
    SolutionSegments way =
        new SolutionSegments(
            motion.problem(length, this::derivative), options, t0, z0, motion.run.tEnd(), memory);
    double[] end = way.endState();
    for (Observation its : found) {
      if (way.endedByEvent()) {
        its.corner(way.end(), end, NONE, Observation.Side.BEFORE);
      } else {
        its.end(way.end(), end);
      }
    }
    double[] values = new double[wanted.size()];
    double[][] slopes = new double[wanted.size()][];
    int next = 0;
    for (int i = 0; i < wanted.size(); i++) {
      GradientOutput one = wanted.get(i);
      double at = way.end();
      Observation.Side side = Observation.Side.SMOOTH;
      if (one.isFound()) {
        Observation its = found.get(next++);
        values[i] = its.value();
        at = its.time();
        side = its.side();
      } else if (one.kind() == Reduction.Kind.AT) {
        at = one.reduction().argument();
        values[i] = at > way.end() ? Double.NaN : columnAt(at, one.column(), way);
      } else if (one.kind() == Reduction.Kind.LAST) {
        values[i] = columnAt(at, one.column(), way);
      } else {
        values[i] = one.ofIntegral(end[n + integralOf[i]], at - t0);
      }
      slopes[i] = Double.isNaN(values[i]) ? filled() : back(i, values[i], at, side, way);
    }
    return new Outcomes(values, slopes, way.steps());
  }

  private double[] filled() {
    double[] none = new double[p];
    Arrays.fill(none, Double.NaN);
    return none;
  }

  private double columnAt(double t, int column, SolutionSegments way) {
    way.at(t, y);
    model.derivative(t, y, rate);
    return columns(t, y, rate)[column];
  }

  private double[] columns(double t, double[] state, double[] stateRate) {
    System.arraycopy(state, 0, both, 0, n);
    System.arraycopy(stateRate, 0, both, n, n);
    return model.columns(t, both);
  }

  private double[] tolerances() {
    double[] tolerances = new double[length];
    System.arraycopy(motion.tolerances(), 0, tolerances, 0, n);
    double time = Math.max(1e-3, motion.run.tEnd() - motion.run.tStart());
    Arrays.fill(tolerances, n, n + integrals, motion.run.absoluteTolerance() * time);
    Arrays.fill(tolerances, n + integrals, length, motion.markerTolerance());
    return tolerances;
  }

  private void derivative(double t, double[] z, double[] zDot) {
    model.derivative(t, z, zDot);
    if (length > n + integrals) {
      zDot[n + integrals] = motion.markerRate(t, z);
    }
    if (integrals > 0) {
      double[] columns = columns(t, z, zDot);
      for (int i = 0; i < integralOf.length; i++) {
        if (integralOf[i] >= 0) {
          zDot[n + integralOf[i]] = wanted.get(i).integrand(columns[wanted.get(i).column()]);
        }
      }
    }
  }

  /** One number's way back. */
  private final class Back {
    final GradientOutput one;
    final SolutionSegments way;

    /** Weight of the integrand in the number; 0 for a number of one time. */
    final double share;

    /** State where a stretch ends, on its side of the transition there. */
    double[] stretchEnd = {};

    double stretchEndTime = Double.NaN;

    /** State where a stretch begins, on its side of the transition there. */
    double[] stretchBegin = {};

    double stretchBeginTime = Double.NaN;

    Back(GradientOutput one, SolutionSegments way, double share) {
      this.one = one;
      this.way = way;
      this.share = share;
    }

    /** Evaluates the state on the stretch. */
    private void stateAt(double t) {
      if (t >= stretchEndTime) {
        System.arraycopy(stretchEnd, 0, y, 0, n);
      } else if (t <= stretchBeginTime) {
        System.arraycopy(stretchBegin, 0, y, 0, n);
      } else {
        way.at(t, y);
      }
    }

    /** The derivatives of λ and of the sums for the parameters. */
    void derivative(double t, double[] u, double[] uDot) {
      stateAt(t);
      System.arraycopy(u, 0, weights, 0, n);
      Arrays.fill(uDot, 0);
      if (share != 0) {
        model.derivative(t, y, rate);
        double value = columns(t, y, rate)[one.column()];
        Arrays.fill(byBoth, 0);
        double weight = share * one.integrandSlope(value);
        model.addColumnAdjoint(t, both, one.column(), weight, byBoth, -1, uDot, n);
        for (int i = 0; i < n; i++) {
          uDot[i] = -byBoth[i];
          weights[i] += byBoth[n + i];
        }
      }
      model.addAdjoint(t, y, weights, -1, uDot, 0, uDot, n);
    }

    void jacobian(double t, double[] u, double[] fu) {
      stateAt(t);
      double[] seed = new double[n + 1 + model.inputCount];
      double[] out = new double[2 * n];
      int size = n + p;
      for (int j = 0; j < n; j++) {
        seed[j] = 1;
        model.equations.tangent(t, y, seed, out);
        seed[j] = 0;
        for (int i = 0; i < n; i++) {
          fu[j * size + i] = -out[n + i];
        }
      }
      for (int j = 0; j < n; j++) {
        double[] unit = new double[n];
        unit[j] = 1;
        double[] none = new double[n];
        double[] byDirection = new double[p];
        model.addAdjoint(t, y, unit, -1, none, 0, byDirection, 0);
        for (int k = 0; k < p; k++) {
          fu[(n + k) * size + j] = byDirection[k];
        }
      }
    }
  }

  /** Returns the derivatives of a number by all directions. */
  private double[] back(
      int number, double value, double at, Observation.Side side, SolutionSegments way) {
    GradientOutput one = wanted.get(number);
    double t0 = motion.run.tStart();
    double end = way.end();
    double[] last = way.endState();
    double integral = one.isIntegral() ? last[n + integralOf[number]] : 0;
    double share = one.isIntegral() ? one.byIntegral(integral, end - t0) : 0;
    Back back = new Back(one, way, share);
    double[] u = new double[n + p];
    double from = one.isIntegral() || one.kind() == Reduction.Kind.LAST ? end : at;
    double slopeOfTime = 0;
    if (side == Observation.Side.BEFORE) {
      FoundEvent corner = eventAt(from, way);
      Transition transition = motion.transitions.get(corner.index());
      Transition.Sides sides = transition.sides(from, corner.before());
      addPoint(one, from, sides.before(), sides.rateBefore(), u);
      double gain = columnRate(one, from, sides.before(), sides.rateBefore());
      addTime(transition, from, sides, gain, u);
      back.stretchEnd = sides.inside();
      back.stretchEndTime = sides.insideTime();
    } else if (!one.isIntegral()) {
      way.at(from, y);
      model.derivative(from, y, rate);
      double[] state = Arrays.copyOf(y, n);
      addPoint(one, from, state, rate.clone(), u);
      if (side == Observation.Side.BEHIND) {
        slopeOfTime = columnRate(one, from, state, rate.clone());
      }
    }
    if (from == end && way.endedByEvent() && !one.isFound()) {
      addStop(one, integral, share, u, way);
    }
    List<FoundEvent> events =
        motion.changes(way.events()).stream()
            .filter(
                event ->
                    event.time() < from
                        || (event.time() == from && side != Observation.Side.BEFORE))
            .sorted(Comparator.comparingDouble(FoundEvent::time))
            .toList();
    double[] tolerances = tolerancesBack(one, value, way);
    double time = from;
    for (int e = events.size() - 1; e >= -1; e--) {
      if (e < 0) {
        back.stretchBeginTime = Double.NaN;
        u = stretch(back, time, t0, u, tolerances);
      } else {
        FoundEvent event = events.get(e);
        Transition transition = motion.transitions.get(event.index());
        Transition.Sides sides = transition.sides(event.time(), event.before());
        back.stretchBegin = sides.outside();
        back.stretchBeginTime = sides.outsideTime();
        u = stretch(back, time, event.time(), u, tolerances);
        time = event.time();
        double[] lambda = Arrays.copyOf(u, n);
        double[] byDirection = Arrays.copyOfRange(u, n, n + p);
        double further = transition.isCorner() ? 0 : share * jumpOfIntegrand(one, time, sides);
        if (time == from) {
          further += slopeOfTime;
        }
        transition.carryBack(time, sides, lambda, byDirection, further);
        System.arraycopy(lambda, 0, u, 0, n);
        System.arraycopy(byDirection, 0, u, n, p);
        back.stretchEnd = sides.inside();
        back.stretchEndTime = sides.insideTime();
      }
    }
    double[] slopes = Arrays.copyOfRange(u, n, n + p);
    for (int k = 0; k < p; k++) {
      slopes[k] += GradientModel.dot(u, model.directions.get(k).start(), n);
    }
    return slopes;
  }

  private double jumpOfIntegrand(GradientOutput one, double t, Transition.Sides sides) {
    if (!one.isIntegral()) {
      return 0;
    }
    double before = one.integrand(columns(t, sides.before(), sides.rateBefore())[one.column()]);
    return before - one.integrand(columns(t, sides.after(), sides.rateAfter())[one.column()]);
  }

  private double[] stretch(Back back, double from, double until, double[] u, double[] tolerances) {
    if (from == until) {
      return u;
    }
    OdeProblem problem =
        Ode.system(n + p, back::derivative).withBreakpoints(model.functions.jumpTimes());
    OdeOptions options =
        OdeOptions.standard()
            .method(motion.method())
            .rtol(motion.run.relativeTolerance())
            .atol(tolerances)
            .keepSteps(false)
            .maxSteps(100_000_000);
    if (motion.method() == OdeMethod.ODE15S) {
      problem = problem.withJacobian(back::jacobian);
    }
    return Ode.solve(problem, from, u, until, options).endState();
  }

  private static FoundEvent eventAt(double t, SolutionSegments way) {
    return way.events().stream().filter(event -> event.time() == t).findFirst().orElseThrow();
  }

  private double columnRate(GradientOutput one, double t, double[] state, double[] stateRate) {
    columns(t, state, stateRate);
    return model.columnRates(t, both.clone())[one.column()];
  }

  private void addTime(
      Transition transition, double t, Transition.Sides sides, double gain, double[] u) {
    double[] lambda = Arrays.copyOf(u, n);
    double[] byDirection = Arrays.copyOfRange(u, n, n + p);
    transition.addTime(t, sides, gain, lambda, byDirection);
    System.arraycopy(lambda, 0, u, 0, n);
    System.arraycopy(byDirection, 0, u, n, p);
  }

  /** Adds the derivatives of a column's value at one time. */
  private void addPoint(
      GradientOutput one, double t, double[] state, double[] stateRate, double[] u) {
    columns(t, state, stateRate);
    double[] at = both.clone();
    double weight =
        one.kind() == Reduction.Kind.CROSSING ? -1 / model.columnRates(t, at)[one.column()] : 1;
    Arrays.fill(byBoth, 0);
    model.addColumnAdjoint(t, at, one.column(), weight, byBoth, 1, u, n);
    System.arraycopy(byBoth, n, weights, 0, n);
    for (int i = 0; i < n; i++) {
      u[i] += byBoth[i];
    }
    if (Arrays.stream(weights).anyMatch(w -> w != 0)) {
      model.addAdjoint(t, state, weights, 1, u, 0, u, n);
    }
  }

  /** Adds what a number gains by a later end, at an event that ends the run. */
  private void addStop(
      GradientOutput one, double integral, double share, double[] u, SolutionSegments way) {
    double t = way.end();
    FoundEvent event = way.events().get(way.events().size() - 1);
    Transition stop = motion.transitions.get(event.index());
    Transition.Sides sides = stop.sides(t, event.before());
    double[] columns = columns(t, sides.before(), sides.rateBefore());
    double gain;
    if (one.isIntegral()) {
      gain =
          share * one.integrand(columns[one.column()])
              + one.byLength(integral, t - motion.run.tStart());
    } else {
      gain = model.columnRates(t, both.clone())[one.column()];
    }
    addTime(stop, t, sides, gain, u);
  }

  /**
   * Returns absolute tolerances of λ and of the sums: an error that changes the number by as little
   * as an error of the size of the tolerances in the state, or in a parameter as a part of its
   * size, relative to the number's own scale.
   */
  private double[] tolerancesBack(GradientOutput one, double number, SolutionSegments way) {
    double[] largest = new double[n];
    double scale = 0;
    double t0 = motion.run.tStart();
    for (int place = PLACES; place >= 0; place--) {
      double t = t0 + (way.end() - t0) * place / PLACES;
      way.at(t, y);
      model.derivative(t, y, rate);
      scale = Math.max(scale, Math.abs(columns(t, y, rate)[one.column()]));
      for (int i = 0; i < n; i++) {
        largest[i] = Math.max(largest[i], Math.abs(y[i]));
      }
    }
    if (one.kind() == Reduction.Kind.INTEGRAL) {
      scale *= way.end() - t0;
    } else if (one.kind() == Reduction.Kind.CROSSING) {
      scale = way.end() - t0;
    }
    // a number may be zero by accident; below the tolerances of the state nothing is asked of it
    double least = motion.run.absoluteTolerance() / motion.run.relativeTolerance();
    double size = Math.max(Math.max(scale, Math.abs(number)), least);
    double error = SHARE * motion.run.relativeTolerance() * size;
    double[] tolerances = new double[n + p];
    for (int i = 0; i < n; i++) {
      tolerances[i] = error / (largest[i] > 0 ? largest[i] : 1);
    }
    for (int k = 0; k < p; k++) {
      tolerances[n + k] = error / model.directions.get(k).size();
    }
    return tolerances;
  }
}
