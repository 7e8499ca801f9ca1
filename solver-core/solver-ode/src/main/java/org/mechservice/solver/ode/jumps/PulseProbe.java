package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Looks into a step along a straight line for a pulse: two jumps of the right-hand side that cancel
 * each other and leave no trace at its ends.
 *
 * <p>Where a solution is straight every step passes the error test by far, so that steps grow to
 * any length, and nothing is known of what lies inside of them. Long ones are looked into, more
 * closely if they are longer than those before.
 */
final class PulseProbe {
  /**
   * Error over the tolerance that no step of a straight stretch has: what it extrapolates is what
   * it finds. Steps with a larger one need no look.
   */
  static final double ERROR_OF_STRAIGHT_STEP = 0.01;

  /** Parts into which a step is divided, times its length over that of the step before. */
  private static final double PARTS = 4;

  /** Fewest parts of the first step: nothing is known yet, and a start at rest makes it long. */
  private static final int FEWEST_AT_FIRST = 20;

  /** Fewest parts of a step that is longer than the one before. */
  private static final int FEWEST = 8;

  /** Fewest parts of a step that is no longer than the one before. */
  private static final int FEWEST_AGAIN = 4;

  /** Most parts of a step. */
  private static final int MOST = 64;

  /** Parts into which the shortest known distance between jumps is divided. */
  private static final double PARTS_OF_DISTANCE = 2;

  /** A step is longer than the one before if it is by this factor. */
  private static final double LONGER = 1.5;

  /**
   * Largest change over half the step, in allowed errors, that counts as rounding: the derivative
   * is then that of the straight line.
   */
  private static final double ROUNDING = 1e-6;

  /**
   * The same, relative to the state: what rounding makes of the line's slope at tight tolerances.
   */
  private static final double ROUNDING_OF_STATE = 16 * Math.ulp(1.0);

  /** Smallest change over half the step, in allowed errors, that a pulse is noticed by. */
  private static final double NOTICED = 1;

  /** Share of the interval that a step must have. */
  private static final double LONG = 1e-3;

  /** Parts of the step to be looked into. */
  private int parts = FEWEST;

  private boolean line;

  /** Change over half the step that counts as rounding, in allowed errors, where a step ends. */
  private double rounding;

  /** The step, and the states at its ends. */
  private double length;

  private double[] from = {};

  private double[] to = {};

  /** Slope of the line between them, as far as it was compared, length n. */
  private final double[] chord;

  private final double[] state;
  private final double[] slope;

  /**
   * @param dimension n
   */
  PulseProbe(int dimension) {
    chord = new double[dimension];
    state = new double[dimension];
    slope = new double[dimension];
  }

  /**
   * Returns whether a step is to be looked into.
   *
   * @param h its size
   * @param before size of the one before; 0 if there was none
   * @param interval of the problem
   * @param distance shortest one known between jumps; 0 if there is none
   */
  boolean wanted(double h, double before, double interval, double distance) {
    line = false;
    double size = Math.abs(h);
    if (!(size >= LONG * Math.abs(interval))) {
      return false;
    }
    boolean longer = size > LONGER * Math.abs(before);
    double byGrowth = longer && before != 0 ? PARTS * size / Math.abs(before) : 0;
    double byDistance = distance == 0 ? 0 : PARTS_OF_DISTANCE * size / distance;
    int fewest = before == 0 ? FEWEST_AT_FIRST : longer ? FEWEST : FEWEST_AGAIN;
    parts = (int) Math.max(fewest, Math.min(MOST, Math.max(byGrowth, byDistance)));
    return true;
  }

  /** Returns where the derivative at an end of the step is to be written, length n. */
  double[] slope() {
    return slope;
  }

  /** Returns whether the step placed last was a straight line as far as asked. */
  boolean sawStraightLine() {
    return line;
  }

  /**
   * Takes the straight line of a step.
   *
   * @param h its size, signed
   * @param from where it starts; kept, not modified
   * @param to where it ends; kept, not modified
   */
  void place(double h, double[] from, double[] to, ErrorNorm norm) {
    line = false;
    length = h;
    rounding = Math.max(ROUNDING, ROUNDING_OF_STATE * norm.of(to));
    this.from = from;
    this.to = to;
  }

  /**
   * Returns whether a derivative is that of the line but for rounding.
   *
   * @param derivative not modified
   */
  boolean straight(double[] derivative, ErrorNorm norm) {
    line = false;
    for (int l = 0; l < chord.length; l++) {
      if (!straight(l, derivative[l], norm)) {
        return false;
      }
    }
    line = difference(derivative, norm) <= rounding;
    return line;
  }

  /**
   * Returns whether a component of a derivative is that of the line but for rounding. Of most steps
   * the first one tells that they are not straight.
   */
  boolean straight(int l, double derivative, ErrorNorm norm) {
    chord[l] = (to[l] - from[l]) / length;
    double difference = Math.abs((derivative - chord[l]) * norm.weight(l));
    return 0.5 * Math.abs(length) * difference <= rounding;
  }

  /** Returns what half the step with a derivative instead of the line's would change. */
  private double difference(double[] derivative, ErrorNorm norm) {
    for (int l = 0; l < chord.length; l++) {
      state[l] = derivative[l] - chord[l];
    }
    return 0.5 * Math.abs(length) * norm.of(state);
  }

  /**
   * Returns the part of the step up to the first place at which the derivative is not that of the
   * line; 1 if there is none.
   */
  double partToPulse(RightHandSide rightHandSide, double t, ErrorNorm norm) {
    for (int i = 1; i < parts; i++) {
      double part = (double) i / parts;
      for (int l = 0; l < chord.length; l++) {
        state[l] = from[l] + part * length * chord[l];
      }
      rightHandSide.evaluateAlways(t + part * length, state, slope);
      if (difference(slope, norm) > NOTICED) {
        return part;
      }
    }
    return 1;
  }
}
