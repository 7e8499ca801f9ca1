package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.step.ExactEndBounds;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.MaximumNorm;

/**
 * ode113: Adams-Bashforth-Moulton predictor-corrector of orders 1 to 13 on variable steps, two
 * evaluations of f per step. The choice for problems that are not stiff, the more so the smoother
 * they are, the more digits are asked for and the more an evaluation costs.
 *
 * <p>Each component is held to max(rtol |y_i|, atol_i) per step, the steps end at the end of the
 * problem exactly, and no step is longer than a tenth of the interval unless {@link
 * IntegratorSettings#maxStep} says otherwise. {@link #order()} is the order k of the predictor, 1
 * to 12; the solution goes on with the corrector of order k + 1. {@link
 * IntegratorSettings#maxOrder} bounds k; 13 means 12. Below a relative tolerance of 1e-11 the
 * round-off of the state is carried along.
 *
 * <p>Stiff problems are solved with tiny steps; {@link IntegrationStatistics#stiffnessSuspected}
 * tells. The error per step is controlled, not the error at the end, which is usually one to two
 * digits larger.
 *
 * <p>Memory: about 75 n numbers of 8 bytes for n unknowns, whatever the order.
 *
 * <p>L. F. Shampine and M. W. Reichelt, <i>The MATLAB ODE Suite</i>, SIAM J. Sci. Comput. 18 (1997)
 * 1, after L. F. Shampine and M. K. Gordon, <i>Computer Solution of Ordinary Differential
 * Equations</i>, 1975.
 */
public final class Ode113 extends AdamsPece {
  /** Relative tolerance below which the round-off of the sums is felt in the result. */
  private static final double COMPENSATED_BELOW = 1e-11;

  private final double relativeTolerance;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode113(IntegratorSettings settings) {
    this(settings, new IntegrationProgress());
  }

  /** Takes turns with another that has the same progress. */
  public Ode113(IntegratorSettings settings, IntegrationProgress progress) {
    super(settings, progress, new MaximumNorm(), new ExactEndBounds());
    relativeTolerance = settings.working().relativeTolerance();
  }

  /** A quarter of the step for which |h y'| is √rtol times the weight max(|y_i|, atol_i / rtol). */
  @Override
  double firstStep(double slope) {
    return 0.25 / (Math.sqrt(relativeTolerance) * slope);
  }

  @Override
  boolean compensates(double roundOff) {
    return relativeTolerance < COMPENSATED_BELOW;
  }
}
