package org.mechservice.solver.integration;

/**
 * An initial value problem in which each component couples only with its neighbours: ∂f_i/∂y_j
 * vanishes unless −l ≤ j − i ≤ u. Implicit methods then difference and solve with the band alone,
 * at a cost proportional to n. The Jacobian, if known too, is written row by row of the band:
 * ∂f_i/∂y_j at i (l + u + 1) + j − i + l.
 */
public interface BandedSystem extends OdeSystem {
  /** Returns l, from 0 to n − 1. */
  int lowerBandwidth();

  /** Returns u, from 0 to n − 1. */
  int upperBandwidth();
}
