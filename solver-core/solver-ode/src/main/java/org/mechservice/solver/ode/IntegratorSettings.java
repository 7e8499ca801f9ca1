package org.mechservice.solver.ode;

import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Tolerances, bounds and mode of an integration.
 *
 * @param relativeTolerance local error allowed relative to the state, at least {@link
 *     #SMALLEST_RELATIVE_TOLERANCE} and below 1
 * @param absoluteTolerance local error allowed where the state is small, per component, positive;
 *     length 1: for all components
 * @param maxStep largest step, positive; infinite: the method's own bound
 * @param initialStep first step tried, positive; 0: the method's own choice
 * @param maxOrder highest order used, 1 to 13; 0: the method's own highest
 * @param maxSteps accepted and rejected steps allowed, positive
 * @param stop asked before every evaluation but that of the start; true ends the step at once
 * @param mode what is done beyond the published programs
 */
public record IntegratorSettings(
    double relativeTolerance,
    List<Double> absoluteTolerance,
    double maxStep,
    double initialStep,
    int maxOrder,
    long maxSteps,
    BooleanSupplier stop,
    Mode mode) {

  public IntegratorSettings {
    absoluteTolerance = List.copyOf(absoluteTolerance);
  }

  /** The standard mode. */
  public IntegratorSettings(
      double relativeTolerance,
      List<Double> absoluteTolerance,
      double maxStep,
      double initialStep,
      int maxOrder,
      long maxSteps,
      BooleanSupplier stop) {
    this(
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        maxSteps,
        stop,
        Mode.STANDARD);
  }

  /** The method's own bounds, one absolute tolerance for all components, no stop signal. */
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

  /** The extensions of an integrator beyond the program it is named after. */
  public enum Mode {
    /** Nothing: the same decisions, so the same steps but for rounding. */
    FAITHFUL,
    /**
     * Implicit methods hold systems with algebraic components, which are in no test themselves, to
     * a third of the tolerances, and steps of an explicit problem in which nothing is stiff to a
     * hundredth ({@code Ode15s}); they trust a measured rate of convergence somewhat more, and take
     * differences in residual form along the step.
     */
    STANDARD,
    /**
     * Like the standard mode, and with a 20th of the tolerances or less in every error test, so
     * that as a rule the solution at the end has the digits asked for but one.
     */
    STRICT
  }

  /** Returns the same settings in another mode. */
  public IntegratorSettings withMode(Mode other) {
    return new IntegratorSettings(
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        maxSteps,
        stop,
        other);
  }

  /**
   * Returns what the tolerances are multiplied by in every error test: 1, or in the strict mode a
   * 20th, unless the limit of the arithmetic is nearer.
   */
  public double toleranceFactor() {
    return mode == Mode.STRICT
        ? Math.min(1, Math.max(STRICT_FACTOR, SMALLEST_RELATIVE_TOLERANCE / relativeTolerance))
        : 1;
  }

  /** Returns the settings with the tolerances that the error tests use. */
  public IntegratorSettings working() {
    return tightened(toleranceFactor());
  }

  /** Returns the settings with a part of the tolerances, as far as the arithmetic allows. */
  public IntegratorSettings tightened(double part) {
    return new IntegratorSettings(
        Math.max(part * relativeTolerance, SMALLEST_RELATIVE_TOLERANCE),
        absoluteTolerance.stream().map(size -> Math.max(part * size, Double.MIN_NORMAL)).toList(),
        maxStep,
        initialStep,
        maxOrder,
        maxSteps,
        stop,
        mode);
  }

  /** Returns the sizes at which the absolute tolerances take over from the relative one. */
  public double[] smallSizes(int dimension) {
    double[] sizes = absoluteTolerances(dimension);
    for (int l = 0; l < sizes.length; l++) {
      double size = sizes[l] / relativeTolerance;
      sizes[l] = Double.isFinite(size) ? size : sizes[l];
    }
    return sizes;
  }

  /**
   * Measured on the problems of the suite and on as many others: it costs 1.3 times the evaluations
   * with Adams methods, 1.4 times with stiff ones. From 0.03 to 0.06 shares and costs go with the
   * factor, up to a few runs that change sides by chance.
   */
  private static final double STRICT_FACTOR = 0.05;

  /** Smallest relative tolerance: about 100 units of round-off, as in the MATLAB ODE Suite. */
  public static final double SMALLEST_RELATIVE_TOLERANCE = 2.3e-14;

  /** Highest order an Adams method knows; the predictor's is one less. */
  private static final int HIGHEST_ORDER = 13;

  /**
   * Checks what does not depend on the problem.
   *
   * @throws IllegalArgumentException naming the setting, its value and what it must be
   */
  public void requireUsable() {
    require(
        relativeTolerance >= SMALLEST_RELATIVE_TOLERANCE && relativeTolerance < 1,
        "relative tolerance",
        relativeTolerance,
        "at least " + SMALLEST_RELATIVE_TOLERANCE + ", the limit of the arithmetic, and below 1");
    require(
        !absoluteTolerance.isEmpty(), "number of absolute tolerances", 0, "1 or one per component");
    for (double tolerance : absoluteTolerance) {
      require(
          tolerance >= Double.MIN_NORMAL && Double.isFinite(tolerance),
          "absolute tolerance",
          tolerance,
          "positive (at least " + Double.MIN_NORMAL + ") and finite");
    }
    require(maxStep > 0, "largest step", maxStep, "positive");
    require(
        initialStep >= 0 && Double.isFinite(initialStep),
        "first step",
        initialStep,
        "positive and finite, or 0 for the method's own choice");
    require(
        maxOrder >= 0 && maxOrder <= HIGHEST_ORDER,
        "highest order",
        maxOrder,
        "from 1 to " + HIGHEST_ORDER + ", or 0 for the method's own");
    require(maxSteps > 0, "number of steps allowed", maxSteps, "positive");
  }

  /**
   * Checks what a problem brings.
   *
   * @throws IllegalArgumentException naming what is wrong, its value and what it must be
   */
  public static void requireUsable(double t0, double tEnd, double[] y0, int dimension) {
    require(Double.isFinite(t0), "start", t0, "finite");
    require(Double.isFinite(tEnd), "end", tEnd, "finite");
    require(Double.isFinite(tEnd - t0), "interval", tEnd - t0, "finite");
    requireUsable(y0, dimension);
  }

  /**
   * Checks a state to begin from.
   *
   * @throws IllegalArgumentException naming what is wrong, its value and what it must be
   */
  public static void requireUsable(double[] y0, int dimension) {
    require(y0.length == dimension, "length of the initial state", y0.length, "" + dimension);
    for (int i = 0; i < y0.length; i++) {
      require(Double.isFinite(y0[i]), "initial state's component " + i, y0[i], "finite");
    }
  }

  /**
   * Checks the derivative that a problem in residual form brings.
   *
   * @throws IllegalArgumentException naming what is wrong, its value and what it must be
   */
  public static void requireUsableDerivative(double[] yDot0, int dimension) {
    require(
        yDot0.length == dimension,
        "length of the initial derivative",
        yDot0.length,
        "" + dimension);
    for (int i = 0; i < yDot0.length; i++) {
      require(Double.isFinite(yDot0[i]), "initial derivative's component " + i, yDot0[i], "finite");
    }
  }

  /**
   * Returns the absolute tolerance of each component.
   *
   * @throws IllegalArgumentException if their number is neither 1 nor the number of components
   */
  public double[] absoluteTolerances(int dimension) {
    int given = absoluteTolerance.size();
    require(
        given == 1 || given == dimension,
        "number of absolute tolerances",
        given,
        "1 or one per component, " + dimension);
    double[] tolerances = new double[dimension];
    for (int i = 0; i < dimension; i++) {
      tolerances[i] = absoluteTolerance.get(given == 1 ? 0 : i);
    }
    return tolerances;
  }

  /** Carries over what decides the steps; refuses other settings than those saved. */
  public void transfer(SavedState state) {
    // First, as a mode decides the tolerances inside: they would be told apart instead.
    state.require("mode", mode);
    state.require("relative tolerance", relativeTolerance);
    state.require("list of absolute tolerances", absoluteTolerance);
    state.require("largest step", maxStep);
    state.require("first step", initialStep);
    state.require("highest order", maxOrder);
  }

  /** Returns the highest order to use by a method that knows the given one. */
  public int highestOrder(int ofMethod) {
    return maxOrder == 0 ? ofMethod : Math.min(maxOrder, ofMethod);
  }

  private static void require(boolean met, String what, Object value, String expected) {
    if (!met) {
      throw new IllegalArgumentException(
          "the " + what + " is " + value + "; it must be " + expected);
    }
  }
}
