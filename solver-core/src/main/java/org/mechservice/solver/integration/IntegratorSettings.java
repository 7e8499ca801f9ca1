package org.mechservice.solver.integration;

import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * How accurately and within which bounds to integrate.
 *
 * @param relativeTolerance local error allowed relative to the state
 * @param absoluteTolerance local error allowed where the state is small, per component; length 1:
 *     for all components
 * @param maxStep largest step; infinite: the method's own bound
 * @param initialStep first step tried; 0: the method's own choice
 * @param maxOrder highest order used; 0: the method's own highest
 * @param maxSteps accepted and rejected steps allowed
 * @param stop asked at every evaluation; true ends the step at once
 */
public record IntegratorSettings(
    double relativeTolerance,
    List<Double> absoluteTolerance,
    double maxStep,
    double initialStep,
    int maxOrder,
    long maxSteps,
    BooleanSupplier stop) {

  public IntegratorSettings {
    absoluteTolerance = List.copyOf(absoluteTolerance);
  }

  /** The method's own bounds, one absolute tolerance for all components, nobody to stop it. */
  public IntegratorSettings(double relativeTolerance, double absoluteTolerance) {
    this(
        relativeTolerance,
        List.of(absoluteTolerance),
        Double.POSITIVE_INFINITY,
        0,
        0,
        Long.MAX_VALUE,
        () -> false);
  }
}
