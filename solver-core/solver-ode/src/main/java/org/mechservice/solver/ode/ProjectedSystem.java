package org.mechservice.solver.ode;

/**
 * A system whose solution obeys equations that the integration itself does not hold exactly, such
 * as constraints differentiated twice, or the unit norm of Euler parameters. Implemented beside
 * {@link OdeSystem} or {@link ResidualSystem}. The integrator projects inside every step before the
 * error is judged (INTEGRATORS §6.6).
 */
public interface ProjectedSystem {
  /**
   * Moves a state onto the manifold by the least change in the system's own metric.
   *
   * @param t where
   * @param y state; overwritten. Left as it is to the bit if it lies on the manifold
   * @return false if there is no way there; the step is then tried shorter
   */
  boolean project(double t, double[] y);

  /**
   * Takes note of an accepted step.
   *
   * @param t its end
   * @param y projected state there; not modified
   */
  default void projectionAccepted(double t, double[] y) {}
}
