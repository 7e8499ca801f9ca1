package org.mechservice.study.optimise;

/** The quantities of a problem as functions of its variables. May be asked by several threads. */
@FunctionalInterface
public interface Response {
  /**
   * Computes the quantities at one point.
   *
   * @param point one value for each variable, in their units; not modified
   * @return one value for each aim, in the units of the outputs
   * @throws PointFailedException if there are none there
   */
  double[] at(double[] point) throws PointFailedException;
}
