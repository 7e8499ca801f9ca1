package org.mechservice.solver.ode;

/**
 * Evaluates the solution inside a step from the numbers that {@link Integrator#keepStep} has kept
 * of it, with the bits of {@link Integrator#interpolate}. One object serves all steps of a method;
 * it has no state and may be used by several threads.
 */
public interface StepPolynomial {
  /**
   * Evaluates state and derivative.
   *
   * @param kept numbers kept; not modified
   * @param from where those of the step begin
   * @param t inside the step
   * @param y state, length n; overwritten
   * @param yDot derivative of the polynomial, length n; overwritten. Of length 0 if not asked for
   */
  void evaluate(double[] kept, int from, double t, double[] y, double[] yDot);
}
