package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;

/**
 * How an iteration matrix that moves with the state leaves its factors behind. With M(q) of another
 * place, the iteration errs by ‖M⁻¹ (M − M_formed)‖ of each change, however short the step is: its
 * rate of convergence grows in proportion to the time between the place of the derivatives and the
 * end of the step. How fast it grows belongs to the motion and outlives the derivatives.
 */
final class MatrixDrift {
  /**
   * Rate from which on new derivatives cost less than the iterations that they save: measured on
   * chains of eight joints and on a driver of 30, where a derivative in closed form costs what ten
   * evaluations cost.
   */
  private static final double SLOW = 0.25;

  /** The same where the derivatives are differences, which cost an evaluation for each column. */
  private static final double SLOW_FOR_DIFFERENCES = 0.7;

  /**
   * Share of the growth that is believed on after the next rate or the next derivatives. If they
   * are formed at every step, none of them meets any growth: it has to be tried again some day.
   */
  private static final double MEMORY = 0.9;

  private final boolean matters;
  private final double slow;

  /** Where the derivatives were formed. */
  private double formedAt = Double.NaN;

  /** Time between there and the end of the step tried last; 0 before they are used. */
  private double distance;

  /** By how much the rate grows, 1/s. */
  private double growth;

  private MatrixDrift(boolean matters, double slow) {
    this.matters = matters;
    this.slow = slow;
  }

  /** That of a matrix whose part ∂F/∂y' stays, or is of no use before a step is accepted. */
  static MatrixDrift none() {
    return new MatrixDrift(false, Double.POSITIVE_INFINITY);
  }

  /**
   * That of a mass matrix that moves with the state.
   *
   * @param byDifferences whether derivatives cost an evaluation for each column
   */
  static MatrixDrift of(boolean byDifferences) {
    return new MatrixDrift(true, byDifferences ? SLOW_FOR_DIFFERENCES : SLOW);
  }

  /** Returns whether there is any. */
  boolean matters() {
    return matters;
  }

  /** Forgets everything: the problem begins, or goes on from another state. */
  void clear() {
    formedAt = Double.NaN;
    distance = 0;
    growth = 0;
  }

  /** Takes note that derivatives were formed at {@code t}. */
  void formed(double t) {
    formedAt = t;
    distance = 0;
    growth *= MEMORY;
  }

  /** Returns whether new derivatives were formed for the end of the step, if that matters. */
  boolean formedHere() {
    return !matters || distance == 0;
  }

  /** Returns whether the iteration for a step that ends at {@code t} would be slow. */
  boolean slowAt(double t) {
    return growth * Math.abs(t - formedAt) > slow;
  }

  /**
   * Goes on to a step that ends at {@code t}; returns its rate over that of the step tried before,
   * which is not finite if that says nothing of it.
   */
  double moveTo(double t) {
    if (!matters) {
      return 1;
    }
    double before = distance;
    distance = Math.abs(t - formedAt);
    return distance / before;
  }

  /**
   * Learns from the rate at which the iteration of that step converged or diverged. Where the
   * derivatives were formed it is that of the equations' curvature, and says nothing of the growth.
   */
  void learn(double rate) {
    if (distance > 0) {
      growth = Math.max(MEMORY * growth, rate / distance);
    }
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    if (!matters) {
      return;
    }
    formedAt = state.number(formedAt);
    distance = state.number(distance);
    growth = state.number(growth);
  }
}
