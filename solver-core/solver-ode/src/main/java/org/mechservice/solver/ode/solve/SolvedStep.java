package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.Integrator;

/** An accepted step as a {@link StepHandler} sees it. One object serves all steps of a run. */
public final class SolvedStep {
  private final Integrator integrator;
  private final double[] unused;
  private double start;
  private double end;
  private boolean stopAsked;

  SolvedStep(Integrator integrator, int dimension) {
    this.integrator = integrator;
    unused = new double[dimension];
  }

  void place(double from, double to) {
    start = from;
    end = to;
  }

  boolean stopAsked() {
    return stopAsked;
  }

  /** Returns where the step begins. */
  public double start() {
    return start;
  }

  /** Returns where the step ends: its own end, that of the run, or an event. */
  public double end() {
    return end;
  }

  /** Returns the order of the formula used. */
  public int order() {
    return integrator.order();
  }

  /**
   * Evaluates the solution inside the step. At an event that ended it this is the state before.
   *
   * @param t from {@link #start} to {@link #end}, both included
   * @param y state, length n; overwritten
   * @throws IllegalArgumentException if {@code t} lies outside of the step or the length is another
   */
  public void at(double t, double[] y) {
    at(t, y, unused);
  }

  /**
   * Evaluates the solution and its derivative inside the step.
   *
   * @param yDot derivative of the interpolating polynomial, length n; overwritten
   */
  public void at(double t, double[] y, double[] yDot) {
    boolean inside = start <= end ? start <= t && t <= end : end <= t && t <= start;
    if (!inside) {
      throw new IllegalArgumentException(
          "t = " + t + " lies outside of the step, " + start + " to " + end);
    }
    OdeSolution.requireLength("y", y, unused.length);
    OdeSolution.requireLength("yDot", yDot, unused.length);
    integrator.interpolate(t, y, yDot);
  }

  /** Ends the integration behind this step; the solution ends with {@link EndReason#STOPPED}. */
  public void stop() {
    stopAsked = true;
  }
}
