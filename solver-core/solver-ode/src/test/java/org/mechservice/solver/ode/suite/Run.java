package org.mechservice.solver.ode.suite;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.StepResult;

/** A problem integrated from start to end. */
@SuppressWarnings("ArrayRecordComponent") // compared by nobody
public record Run(StepResult result, double[] atEnd, Integrator integrator) {
  /** Integrates; the state is that at the end, or where it stopped. */
  public static Run of(
      Integrator integrator, OdeSystem system, double t0, double[] y0, double tEnd) {
    StepResult result = integrator.start(system, t0, y0, tEnd);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    double end = result == StepResult.REACHED_END ? tEnd : integrator.time();
    return new Run(result, state(integrator, end, y0.length), integrator);
  }

  /** Integrates a problem of the suite. */
  public static Run of(Integrator integrator, SuiteProblem problem) {
    VerifiedValues reference = problem.reference();
    return of(integrator, problem, 0, reference.initialState(), reference.end());
  }

  /** Returns the settings that the suite asks for: absolute tolerances scaled by component. */
  public static IntegratorSettings settings(SuiteProblem problem, double relativeTolerance) {
    List<Double> absolute =
        Arrays.stream(problem.reference().scale())
            .mapToObj(scale -> scale * relativeTolerance)
            .toList();
    return new IntegratorSettings(
        relativeTolerance, absolute, Double.POSITIVE_INFINITY, 0, 0, Long.MAX_VALUE, () -> false);
  }

  public static double[] state(Integrator integrator, double t, int dimension) {
    double[] y = new double[dimension];
    integrator.interpolate(t, y, new double[dimension]);
    return y;
  }

  public IntegrationStatistics statistics() {
    return integrator.statistics();
  }
}
