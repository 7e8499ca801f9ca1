package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/**
 * ∂F/∂y and ∂F/∂y' where they were formed last, and the linear algebra with them.
 *
 * <p>Not sealed: a class file names what its type permits, and a JAR of one method would carry all
 * of them.
 */
public interface ResidualLinearisation {
  /** Forms the derivatives. */
  TrialOutcome form(double t, double[] y, double[] yDot);

  /** Has the columns of derivatives by differences looked at. */
  void testColumns(ColumnTest.Maker tests);

  /** Returns whether {@link #formMatrix} is cheaper than to form both derivatives. */
  boolean formsMatrix();

  /** Brings hγ ∂F/∂y + ∂F/∂y', but not each of its parts, up to date. */
  TrialOutcome formMatrix(double t, double[] y, double[] yDot, double hGamma);

  /**
   * Tells how fast components move that move y little in a step, for differences of F in y'.
   *
   * @param rate slope of a component over the size below which it is negligible, positive
   */
  void knowRate(double rate);

  /** Forgets derivatives that were stopped half way. */
  void abandon();

  /** Factors hγ ∂F/∂y + ∂F/∂y'; returns whether it is regular. */
  boolean factor(double hGamma);

  /**
   * Solves with the last factors.
   *
   * @param hGamma that of the factors
   * @param residual −F at entry. At return the change of y, or for hγ = 0 that of y'_d and y_a
   */
  void solve(double hGamma, double[] residual);

  /**
   * Solves as in a step so short that nothing is stiff; the last factors stay.
   *
   * @param residual −F at entry. At return y', or what y is to change by where it has no derivative
   *     in F
   * @return false, with the residual as it was, if that does not determine the solution
   */
  boolean solveUnstiff(double[] residual);

  /** Returns whether a component's derivative does not appear in F. */
  boolean algebraic(int component);

  /**
   * Returns whether components declared algebraic are to be looked at again behind the start, where
   * the coefficient of a derivative may have been zero.
   */
  boolean doubtsDeclarations();

  /** Returns whether it is known before anything is formed that F has the derivatives of all. */
  boolean allDifferential();

  /** Returns the component at whose column the last factorisation failed. */
  int singularComponent();

  /** Returns an estimate of the reciprocal condition of the matrix; 1 if nothing is known of it. */
  double reciprocalCondition();

  /** Returns the row that made the derivatives not finite; −1 if none can be named. */
  int notFiniteComponent();

  /**
   * Returns how large the terms are that make up a row of F at a point; 0 if nothing is known of
   * it.
   */
  double magnitude(int row);

  /** Carries the derivatives over, and what is known for the next ones. */
  void transfer(SavedState state);
}
