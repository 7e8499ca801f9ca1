package org.mechservice.benchmarks.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.WarmUpRounds;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;

/** Runs the product's integrators on the suite. */
final class SuiteRunner {
  /** An explicit method on a stiff problem takes steps without end. */
  private static final long MOST_STEPS = 100_000;

  private SuiteRunner() {}

  /** Runs whose time is taken, of which the median counts. */
  static final int REPEATS = 11;

  /** A run that takes longer, s, is timed by its first run alone. */
  static final double LONG = 1;

  /** Rounds of this time, s, are compared with those before them, to see whether all is warm. */
  private static final double WARM = 0.3;

  /** Returns the names of the integrators that take a problem, our own first. */
  static List<String> integrators(ProblemFile problem) {
    List<String> names = new ArrayList<>();
    if (problem.isExplicit()) {
      names.addAll(List.of("ode113", "DE", "ode15s"));
    }
    names.add("ode15sR");
    names.addAll(HipparchusRunner.integrators(problem));
    return names;
  }

  /**
   * Runs a problem with all integrators at all tolerances: each once, for its error, then warm in
   * rounds, every run once per round.
   */
  static List<SuiteRun> all(ProblemFile problem, double[] tolerances, double limit) {
    List<SuiteRun> runs = new ArrayList<>();
    for (String name : integrators(problem)) {
      runs.addAll(runs(problem, name, tolerances, limit));
    }
    List<SuiteRun> repeated =
        runs.stream().filter(run -> run.cause().isEmpty() && run.seconds() <= LONG).toList();
    double[][] seconds = new double[repeated.size()][REPEATS];
    WarmUpRounds.until(
        () -> repeated.stream().mapToDouble(run -> again(problem, run, limit)).sum(),
        WARM,
        ReportProgress.SILENT,
        0);
    for (int round = 0; round < REPEATS; round++) {
      for (int i = 0; i < repeated.size(); i++) {
        seconds[i][round] = again(problem, repeated.get(i), limit);
      }
    }
    for (int i = 0; i < repeated.size(); i++) {
      int place = runs.indexOf(repeated.get(i));
      runs.set(place, runs.get(place).taking(Quantiles.median(seconds[i])));
    }
    return runs;
  }

  private static double again(ProblemFile problem, SuiteRun first, double limit) {
    return run(problem, first.solver(), first.tolerance(), 5 * limit).seconds();
  }

  /** Runs a problem with an integrator at all tolerances, each once. */
  static List<SuiteRun> runs(ProblemFile problem, String name, double[] tolerances, double limit) {
    List<SuiteRun> runs = new ArrayList<>();
    for (double tolerance : tolerances) {
      runs.add(run(problem, name, tolerance, limit));
    }
    return runs;
  }

  private static SuiteRun run(ProblemFile problem, String name, double tolerance, double limit) {
    if (HipparchusRunner.integrators(problem).contains(name)) {
      return HipparchusRunner.run(problem, name, tolerance, limit);
    }
    SuiteEquations equations = new SuiteEquations(problem);
    Deadline deadline = new Deadline(limit);
    Integrator integrator = create(name, settings(problem, tolerance, deadline::isOver));
    double t0 = ProblemFile.numbers(List.of(problem.t0))[0];
    double t1 = equations.number(problem.t1);
    double[] y = ProblemFile.numbers(problem.y0);
    StepResult result = start(integrator, equations, problem, t0, y, t1);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    long evaluations = integrator.statistics().evaluations();
    long steps = integrator.statistics().steps();
    double seconds = deadline.seconds();
    if (result != StepResult.REACHED_END) {
      String cause = result == StepResult.STOPPED ? deadline.cause() : cause(integrator);
      return new SuiteRun(
          problem.id, name, tolerance, Double.NaN, evaluations, steps, seconds, cause);
    }
    integrator.interpolate(t1, y, new double[y.length]);
    double error = problem.error(y);
    return new SuiteRun(problem.id, name, tolerance, error, evaluations, steps, seconds, "");
  }

  private static String cause(Integrator integrator) {
    return integrator.failure().cause().toString();
  }

  private static StepResult start(
      Integrator integrator,
      SuiteEquations equations,
      ProblemFile problem,
      double t0,
      double[] y0,
      double t1) {
    if (!(integrator instanceof ResidualIntegrator residual)) {
      return integrator.start(equations, t0, y0, t1);
    }
    double[] slope = ProblemFile.numbers(problem.yp0);
    if (slope.length == 0) {
      slope = new double[y0.length];
      equations.derivative(t0, y0, slope);
    }
    return residual.start(equations, t0, y0, slope, t1);
  }

  private static IntegratorSettings settings(
      ProblemFile problem, double tolerance, BooleanSupplier stop) {
    List<Double> absolute = new ArrayList<>();
    for (double scale : ProblemFile.numbers(problem.scale)) {
      absolute.add(tolerance * scale);
    }
    return new IntegratorSettings(
        tolerance, absolute, Double.POSITIVE_INFINITY, 0, 0, MOST_STEPS, stop);
  }

  private static Integrator create(String name, IntegratorSettings settings) {
    Function<IntegratorSettings, Integrator> maker =
        switch (name) {
          case "ode113" -> Ode113::new;
          case "DE" -> De::new;
          case "ode15s" -> Ode15s::new;
          default -> Ode15sR::new;
        };
    return maker.apply(settings);
  }
}
