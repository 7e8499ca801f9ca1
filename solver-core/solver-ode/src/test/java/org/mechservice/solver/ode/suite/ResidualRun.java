package org.mechservice.solver.ode.suite;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.stiff.Ode15sR;

/** A problem in residual form integrated from start to end. */
@SuppressWarnings("ArrayRecordComponent") // compared by nobody
public record ResidualRun(
    ResidualProblem problem, StepResult result, double[] atEnd, Ode15sR integrator) {
  /** Integrates a problem of the suite at a relative tolerance. */
  public static ResidualRun of(ResidualProblem problem, double tolerance) {
    return of(integrator(problem, tolerance), problem);
  }

  /** Integrates a problem of the suite. */
  public static ResidualRun of(Ode15sR integrator, ResidualProblem problem) {
    VerifiedValues reference = problem.reference();
    StepResult result =
        integrator.start(
            problem,
            problem.start(),
            reference.initialState(),
            problem.initialDerivative(),
            reference.end());
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    double[] y = Run.state(integrator, integrator.time(), problem.dimension());
    return new ResidualRun(problem, result, y, integrator);
  }

  public static Ode15sR integrator(ResidualProblem problem, double tolerance) {
    return new Ode15sR(settings(problem, tolerance));
  }

  /** Returns the settings that the suite asks for: absolute tolerances scaled by component. */
  public static IntegratorSettings settings(ResidualProblem problem, double tolerance) {
    List<Double> absolute =
        Arrays.stream(problem.reference().scale()).mapToObj(scale -> scale * tolerance).toList();
    return new IntegratorSettings(
        tolerance, absolute, Double.POSITIVE_INFINITY, 0, 0, Long.MAX_VALUE, () -> false);
  }

  /** Returns the correct digits of the scored components at the end. */
  public double digits() {
    return problem.mixedDigits(atEnd, problem.reference().atEnd());
  }

  public IntegrationStatistics statistics() {
    return integrator.statistics();
  }
}
