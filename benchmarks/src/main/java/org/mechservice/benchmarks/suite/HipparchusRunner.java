package org.mechservice.benchmarks.suite;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.ODEStateAndDerivative;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.AdamsMoultonIntegrator;
import org.hipparchus.ode.nonstiff.AdaptiveStepsizeIntegrator;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;

/** Hipparchus' integrators on the same equations, compiled the same way, in the same run. */
final class HipparchusRunner {
  private static final int ADAMS_STEPS = 8;

  private static final Map<String, BiFunction<double[], double[], AdaptiveStepsizeIntegrator>>
      INTEGRATORS =
          Map.of(
              "Hipparchus DormandPrince853",
              (span, tolerances) ->
                  new DormandPrince853Integrator(
                      span[0], span[1], absolute(tolerances), relative(tolerances)),
              "Hipparchus GraggBulirschStoer",
              (span, tolerances) ->
                  new GraggBulirschStoerIntegrator(
                      span[0], span[1], absolute(tolerances), relative(tolerances)),
              "Hipparchus AdamsMoulton 8",
              (span, tolerances) ->
                  new AdamsMoultonIntegrator(
                      ADAMS_STEPS, span[0], span[1], absolute(tolerances), relative(tolerances)));

  private HipparchusRunner() {}

  /** The first number is the relative tolerance, the others are the absolute ones. */
  private static double[] absolute(double[] tolerances) {
    return Arrays.copyOfRange(tolerances, 1, tolerances.length);
  }

  private static double[] relative(double[] tolerances) {
    double[] relative = new double[tolerances.length - 1];
    Arrays.fill(relative, tolerances[0]);
    return relative;
  }

  /** Returns the names of the integrators that take a problem: all are for nonstiff ones. */
  static List<String> integrators(ProblemFile problem) {
    return problem.isExplicit() && !problem.isStiff()
        ? INTEGRATORS.keySet().stream().sorted().toList()
        : List.of();
  }

  /** Runs a problem once. */
  static SuiteRun run(ProblemFile problem, String name, double tolerance, double limit) {
    SuiteEquations equations = new SuiteEquations(problem);
    double[] scales = ProblemFile.numbers(problem.scale);
    double[] tolerances = new double[scales.length + 1];
    tolerances[0] = tolerance;
    for (int i = 0; i < scales.length; i++) {
      tolerances[i + 1] = tolerance * scales[i];
    }
    double t0 = ProblemFile.numbers(List.of(problem.t0))[0];
    double t1 = equations.number(problem.t1);
    double[] span = {0, t1 - t0};
    AdaptiveStepsizeIntegrator integrator = maker(name).apply(span, tolerances);
    Deadline deadline = new Deadline(limit);
    Watched watched = new Watched(equations, deadline);
    long[] steps = new long[1];
    integrator.addStepHandler(interpolator -> steps[0]++);
    String cause = "";
    double error = Double.NaN;
    try {
      ODEStateAndDerivative end =
          integrator.integrate(watched, new ODEState(t0, ProblemFile.numbers(problem.y0)), t1);
      error = problem.error(end.getPrimaryState());
    } catch (TooLong e) {
      cause = deadline.cause();
    } catch (MathRuntimeException e) {
      cause = String.valueOf(e.getMessage());
    }
    double seconds = deadline.seconds();
    return new SuiteRun(
        problem.id, name, tolerance, error, watched.evaluations, steps[0], seconds, cause);
  }

  private static BiFunction<double[], double[], AdaptiveStepsizeIntegrator> maker(String name) {
    BiFunction<double[], double[], AdaptiveStepsizeIntegrator> maker = INTEGRATORS.get(name);
    if (maker == null) {
      throw new IllegalArgumentException(name);
    }
    return maker;
  }

  /** Ends a run whose time is over. */
  private static final class TooLong extends RuntimeException {
    private static final long serialVersionUID = 1;
  }

  private static final class Watched implements OrdinaryDifferentialEquation {
    private final SuiteEquations equations;
    private final Deadline deadline;
    private long evaluations;

    Watched(SuiteEquations equations, Deadline deadline) {
      this.equations = equations;
      this.deadline = deadline;
    }

    @Override
    public int getDimension() {
      return equations.dimension();
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
      if (deadline.isOver()) {
        throw new TooLong();
      }
      evaluations++;
      double[] slope = new double[y.length];
      equations.derivative(t, y, slope);
      return slope;
    }
  }
}
