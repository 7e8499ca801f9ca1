package org.mechservice.solver.ode;

/**
 * A system whose groups of components have norm one, and of which only the direction matters: the
 * Euler parameters of a rotation (docs/theory/motion.md#positions). The derivative of a group must
 * be linear and homogeneous in it, and that of every other component must not depend on its norm.
 *
 * <p>The norm then drifts by errors of integration alone. When it has left one by {@link
 * #NORM_DRIFT} at an accepted step, the integrator multiplies the group in the state and in every
 * difference of its history by the reciprocal: the scaled history is that of the scaled solution,
 * so nothing is restarted and no error is made.
 */
public interface UnitNormGroups extends ErrorWeightGroups {
  /** Departure of the norm from one at which a group is scaled back. */
  double NORM_DRIFT = 1e-8;
}
