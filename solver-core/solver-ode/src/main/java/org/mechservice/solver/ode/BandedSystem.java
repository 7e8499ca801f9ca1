package org.mechservice.solver.ode;

/**
 * A system in which each component couples only with its neighbours: ∂f_i/∂y_j, or in residual form
 * ∂F_i/∂y_j and ∂F_i/∂y'_j, vanish unless −l ≤ j − i ≤ u. Implemented beside {@link OdeSystem} or
 * {@link ResidualSystem}.
 *
 * <p>Implicit methods then difference and solve with the band alone, at a cost proportional to n:
 * columns l + u + 1 apart share no row, so that one evaluation serves all of them (Curtis, Powell
 * and Reid, J. Inst. Maths Applics 13 (1974) 117). Derivatives that are known are written row by
 * row of the band: what belongs to row i and column j at i (l + u + 1) + j − i + l.
 */
public interface BandedSystem {
  /** Returns l, from 0 to n − 1. */
  int lowerBandwidth();

  /** Returns u, from 0 to n − 1. */
  int upperBandwidth();
}
