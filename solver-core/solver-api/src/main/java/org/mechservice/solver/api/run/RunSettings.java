package org.mechservice.solver.api.run;

import java.util.List;
import org.mechservice.solver.catalogue.Accuracy;

/**
 * The interval of a run, the times of its rows, its integrator and its tolerances.
 *
 * @param tStart start, s
 * @param tEnd end, s; at or after the start
 * @param tStep distance of the output rows, s; positive. The end is a row even if the distance does
 *     not divide the interval
 * @param integrator {@code ode113}, {@code DE}, {@code ode15s}, {@code ode15sR} or {@code
 *     switching}, which is ode113 and, while the motion is stiff, ode15s
 * @param relativeTolerance local error relative to the state
 * @param absoluteTolerance local error below which a displacement does not matter, m
 * @param maxStep largest step, s; infinite: the integrator's own bound
 * @param initialStep first attempted step, s; 0: the integrator's own choice
 * @param maxOrder highest order used; 0: the method's own highest
 * @param angleTolerance as {@code absoluteTolerance} of angles, rad, and of Euler parameters
 * @param velocityTolerance of rates of displacements, m/s
 * @param angularVelocityTolerance of angular velocities, rad/s
 * @param accuracy relation of the final error to the tolerances
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
    int maxOrder,
    double angleTolerance,
    double velocityTolerance,
    double angularVelocityTolerance,
    Accuracy accuracy) {

  /** Settings of standard accuracy. */
  public RunSettings(
      double tStart,
      double tEnd,
      double tStep,
      String integrator,
      double relativeTolerance,
      double absoluteTolerance,
      double maxStep,
      double initialStep,
      int maxOrder,
      double angleTolerance,
      double velocityTolerance,
      double angularVelocityTolerance) {
    this(
        tStart,
        tEnd,
        tStep,
        integrator,
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        angleTolerance,
        velocityTolerance,
        angularVelocityTolerance,
        Accuracy.STANDARD);
  }

  /** Settings of standard accuracy with one absolute tolerance for all states. */
  public RunSettings(
      double tStart,
      double tEnd,
      double tStep,
      String integrator,
      double relativeTolerance,
      double absoluteTolerance,
      double maxStep,
      double initialStep,
      int maxOrder) {
    this(
        tStart,
        tEnd,
        tStep,
        integrator,
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        absoluteTolerance,
        absoluteTolerance,
        absoluteTolerance);
  }

  /** Settings of standard accuracy; the integrator chooses step sizes and order. */
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

  /** Returns whether all states have the same absolute tolerance. */
  public boolean hasOneTolerance() {
    return angleTolerance == absoluteTolerance
        && velocityTolerance == absoluteTolerance
        && angularVelocityTolerance == absoluteTolerance;
  }

  /**
   * Returns the absolute tolerance of a state.
   *
   * @param unit its SI unit
   */
  public double absoluteTolerance(String unit) {
    return switch (unit) {
      case "m" -> absoluteTolerance;
      case "m/s" -> velocityTolerance;
      case "rad/s" -> angularVelocityTolerance;
      default -> angleTolerance;
    };
  }

  /** Returns the settings with another end and another distance of the rows, s. */
  public RunSettings withOutput(double end, double step) {
    return new RunSettings(
        tStart,
        end,
        step,
        integrator,
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        angleTolerance,
        velocityTolerance,
        angularVelocityTolerance,
        accuracy);
  }

  /** Returns the settings with another integrator. */
  public RunSettings withIntegrator(String other) {
    return new RunSettings(
        tStart,
        tEnd,
        tStep,
        other,
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        angleTolerance,
        velocityTolerance,
        angularVelocityTolerance,
        accuracy);
  }

  /** Returns the settings with another relative tolerance. */
  public RunSettings withRelativeTolerance(double tolerance) {
    return new RunSettings(
        tStart,
        tEnd,
        tStep,
        integrator,
        tolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        angleTolerance,
        velocityTolerance,
        angularVelocityTolerance,
        accuracy);
  }

  /** Returns the settings with another accuracy. */
  public RunSettings withAccuracy(Accuracy other) {
    return new RunSettings(
        tStart,
        tEnd,
        tStep,
        integrator,
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        angleTolerance,
        velocityTolerance,
        angularVelocityTolerance,
        other);
  }

  /**
   * Returns settings with other absolute tolerances.
   *
   * @param tolerances one for all states, or four: of displacements, angles, velocities, angular
   *     velocities
   */
  public RunSettings withTolerances(List<Double> tolerances) {
    int last = tolerances.size() - 1;
    return new RunSettings(
        tStart,
        tEnd,
        tStep,
        integrator,
        relativeTolerance,
        tolerances.get(0),
        maxStep,
        initialStep,
        maxOrder,
        tolerances.get(Math.min(1, last)),
        tolerances.get(Math.min(2, last)),
        tolerances.get(last),
        accuracy);
  }
}
