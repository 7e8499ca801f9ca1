package org.mechservice.solver.api;

/**
 * When a run starts and ends, which rows it puts out, and how it is integrated.
 *
 * @param tStart start, s
 * @param tEnd end, s; at or after the start
 * @param tStep distance of the output rows, s; positive. The end is a row even where the distance
 *     does not divide the interval
 * @param integrator {@code ode113} or {@code DE}
 * @param relativeTolerance local error relative to the state
 * @param absoluteTolerance local error in SI units below which a state does not matter
 * @param maxStep largest step, s; infinite: the integrator's own bound
 * @param initialStep first step tried, s; 0: the integrator's own choice
 * @param maxOrder highest order used; 0: the method's own highest
 */
public record RunSettings(
    double tStart,
    double tEnd,
    double tStep,
    String integrator,
    double relativeTolerance,
    double absoluteTolerance,
    double maxStep,
    double initialStep,
    int maxOrder) {

  /** Settings that leave the step sizes and the order to the integrator. */
  public RunSettings(
      double tStart,
      double tEnd,
      double tStep,
      String integrator,
      double relativeTolerance,
      double absoluteTolerance) {
    this(
        tStart,
        tEnd,
        tStep,
        integrator,
        relativeTolerance,
        absoluteTolerance,
        Double.POSITIVE_INFINITY,
        0,
        0);
  }
}
