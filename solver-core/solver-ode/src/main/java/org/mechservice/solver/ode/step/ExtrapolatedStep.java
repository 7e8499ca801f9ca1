package org.mechservice.solver.ode.step;

/** A step of a method that extrapolates f from its last values, as Adams methods do. */
public interface ExtrapolatedStep extends TriedStep {
  /** Returns f at the beginning of the step. */
  double[] slope();

  /** Returns f at its end as it was extrapolated. */
  double[] foreseenSlope();

  /** Returns the component in which f at the prediction is farthest from that. */
  int worstComponent();

  /**
   * Returns the size of the i-th difference of f before the step, rescaled to the step; 0 if it is
   * not known.
   *
   * @param i 1 for f itself, to {@link #order} + 1
   */
  double difference(int i, int component);

  /**
   * Extrapolates y and f into the step.
   *
   * @param part of the step, 0 to 1
   * @param y overwritten
   * @param yDot overwritten
   */
  void extrapolate(double part, double[] y, double[] yDot);
}
