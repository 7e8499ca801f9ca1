package org.mechservice.benchmarks;

import org.hipparchus.ode.nonstiff.AdamsMoultonIntegrator;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.mechservice.solver.ode.IntegratorFactory;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.switching.Switching;

/** The integrators that are compared: ours, and those of Hipparchus that fit the same problems. */
public enum ComparedIntegrator {
  /** Ours. */
  ODE113,
  /** Ours. */
  DE,
  /** Ours. */
  ODE15S,
  /** Ours: ode113, and ode15s where it gets stiff. */
  SWITCHING,
  /** Adams and Moulton of fixed order, of Hipparchus. */
  HIPPARCHUS_ADAMS,
  /** Dormand and Prince of order 8, of Hipparchus. */
  HIPPARCHUS_DOP853;

  /** Returns a run of a problem, to be done any number of times. */
  ProblemRun run(double tolerance) {
    return switch (this) {
      case ODE113 -> own(Ode113::new, tolerance);
      case DE -> own(De::new, tolerance);
      case ODE15S -> own(Ode15s::new, tolerance);
      case SWITCHING -> own(Switching::new, tolerance);
      case HIPPARCHUS_ADAMS ->
          new HipparchusRun(new AdamsMoultonIntegrator(6, 0, 1e9, tolerance, tolerance));
      case HIPPARCHUS_DOP853 ->
          new HipparchusRun(new DormandPrince853Integrator(0, 1e9, tolerance, tolerance));
    };
  }

  private static ProblemRun own(IntegratorFactory integrators, double tolerance) {
    return new OwnRun(integrators.create(new IntegratorSettings(tolerance, tolerance)));
  }

  /** An integrator at work on a problem. */
  interface ProblemRun {
    /** Integrates from start to end; returns what it cost. */
    Cost toEnd(SuiteProblem problem);
  }

  /**
   * Cost of a run.
   *
   * @param steps accepted steps
   * @param evaluations of the right-hand side
   */
  public record Cost(long steps, long evaluations) {}
}
