package org.mechservice.library.proof;

/**
 * The right value of a column in the last row.
 *
 * <p>An error is allowed up to {@link #STEPS} times what one disturbance of the size of the
 * tolerances changes ({@code spread}): a hit, a pulse or a corner is some ten to hundred steps of
 * which each may leave an error of the tolerance, and in a stiff contact an error of the place
 * comes back as one of velocity. Whatever the tolerance, it is no more than {@link #PART} of what
 * the hidden thing does to the scene ({@code effect}): beyond that, a user takes the motion for
 * another one.
 *
 * @param column name of the column
 * @param value the right value
 * @param spread change of the value by one error of the tolerances in each state
 * @param effect change of the value by the thing that a step could pass over; positive
 */
record Expected(String column, double value, double spread, double effect) {
  /** Errors of one tolerance each that may add up, worst case. */
  static final double STEPS = 1000;

  /** Largest part of the effect that may be wrong. */
  static final double PART = 0.05;

  /** Errors of the references themselves, relative to the value and the effect: a depth of 10 µm at
   * a place of 50 m is known to 1e-9 of itself, and so is the time in contact. */
  private static final double REFERENCE = 1e-7;

  /** Returns the largest error that is right. */
  double bound() {
    double own = REFERENCE * (Math.abs(value) + effect);
    return Math.max(own, Math.min(STEPS * spread, PART * effect));
  }

  /** Returns the error of a value, where 1 is the largest that is right. */
  double error(double actual) {
    double error = Math.abs(actual - value) / bound();
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }
}
