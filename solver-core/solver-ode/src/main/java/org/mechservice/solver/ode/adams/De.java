package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.step.EuclideanNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.PastEndBounds;

/**
 * DE: the Adams method of {@link Ode113} with norm, weights and end of the program of Shampine and
 * Gordon 1975.
 *
 * <p>The local error is held in the Euclidean norm with weights rtol |y_i| + atol_i, so that many
 * components together are held tighter than by ode113. Steps pass the end of the problem, by at
 * most nine times its length, and the solution there is interpolated: the right-hand side must make
 * sense beyond the end. {@link #time()} is the end then, and {@link #stepSize()} the whole step.
 *
 * <p>The original returns to its caller every 500 steps with a flag; here {@link
 * IntegratorSettings#maxSteps} limits the work, and its other flag, that the problem appears to be
 * stiff, is {@link IntegrationStatistics#stiffnessSuspected}. Order and {@link
 * IntegratorSettings#maxOrder} as for ode113: 1 to 12, and 13 for the corrector. The round-off of
 * the state is carried along when the tolerance comes within a factor of 200 of it.
 *
 * <p>Memory: about 75 n numbers of 8 bytes for n unknowns, whatever the order.
 *
 * <p>L. F. Shampine and M. K. Gordon, <i>Computer Solution of Ordinary Differential Equations</i>,
 * 1975.
 */
public final class De extends AdamsPece {
  /** Round-off, in units of the tolerance, from which on it is carried along. */
  private static final double COMPENSATED_FROM = 0.5 / 100;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public De(IntegratorSettings settings) {
    super(settings, new IntegrationProgress(), new EuclideanNorm(), new PastEndBounds());
  }

  /** A quarter of the step at which a first-order error estimate, h² ‖y'‖, is the tolerance. */
  @Override
  double firstStep(double slope) {
    return 0.25 * Math.sqrt(1 / slope);
  }

  @Override
  boolean compensates(double roundOff) {
    return roundOff >= COMPENSATED_FROM;
  }
}
