package org.mechservice.study.optimise;

/** First derivatives of several functions of several variables. */
@FunctionalInterface
public interface Derivatives {
  /**
   * Computes the derivatives at a point.
   *
   * @param point one number for each variable; not modified
   * @return row i, column j: the derivative of function i by variable j
   * @throws PointFailedException if the functions cannot be computed there
   */
  double[][] at(double[] point) throws PointFailedException;
}
