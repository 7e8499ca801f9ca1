package org.mechservice.solver.expression;

/**
 * A step of a tape on one or two earlier values, f(a) or f(a, b), with its partial derivatives: an
 * {@link Operation}, or the curve of a table.
 */
interface TapeStep {
  /**
   * Returns f, or NaN if f is not defined; functions of one argument ignore b. {@code d} provides
   * scratch.
   */
  double value(double a, double b, LocalDerivatives d);

  /** Writes the partial derivatives; not finite if they do not exist. */
  void differentiate(double a, double b, LocalDerivatives d);
}
