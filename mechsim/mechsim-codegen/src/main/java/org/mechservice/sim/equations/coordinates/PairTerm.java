package org.mechservice.sim.equations.coordinates;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A function of the pose of body B relative to body A, with its derivatives: f' = byTurn · ω +
 * byShift · ρ', f'' = byTurn · ω' + byShift · ρ'' + bend.
 *
 * @param value rad or m
 * @param byTurn its gradient by small rotations of B, in A's axes
 * @param byShift its gradient by displacements of B's point, in A's axes
 * @param bend the part of f'' that is quadratic in ω and ρ'
 * @param countsTurns whether it is an angle, known up to whole turns
 */
public record PairTerm(
    Scalar value, ScalarVector byTurn, ScalarVector byShift, Scalar bend, boolean countsTurns) {

  /** Returns its rate of change. */
  public Scalar rate(ScalarVector omega, ScalarVector rate) {
    return byTurn.dot(omega).plus(byShift.dot(rate));
  }

  /** Returns its second derivative. */
  public Scalar acceleration(ScalarVector alpha, ScalarVector acceleration) {
    return rate(alpha, acceleration).plus(bend);
  }
}
