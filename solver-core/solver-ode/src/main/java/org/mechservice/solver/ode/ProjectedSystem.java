package org.mechservice.solver.ode;

/**
 * A system whose solution obeys equations that the integration itself does not hold exactly, such
 * as constraints differentiated twice, or the unit norm of Euler parameters. Implemented beside
 * {@link OdeSystem} or {@link ResidualSystem}. The integrator projects inside every step: Adams
 * methods before the second evaluation, implicit ones before the error is judged
 * (docs/theory/integrators.md#closed-loops-within-a-step).
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
   * Removes from the estimated error of a step what a projection removes, too: its part across the
   * manifold. Rounding errors of the relations appear in that part alone. Steps, however short, do
   * not reduce them, and no step would pass where the tolerances are finer. Stiff methods ask for
   * it before they reject a step; so does CVODE (Hindmarsh et al. 2005, ACM TOMS 31, 363).
   *
   * @param t end of the step
   * @param y state there; not modified
   * @param error overwritten
   * @return false if that part is not known; the error is then as it was
   */
  default boolean projectError(double t, double[] y, double[] error) {
    return false;
  }

  /**
   * Takes note of an accepted step.
   *
   * @param t its end
   * @param y projected state there; not modified
   */
  default void projectionAccepted(double t, double[] y) {}
}
