package org.mechservice.library.proof;

/**
 * The right value of a column in the last row.
 *
 * <p>An error is allowed up to {@link #STEPS} times what one disturbance of the size of the
 * tolerances changes ({@code spread}): a hit, a pulse or a corner is some ten to hundred steps of
 * which each may leave an error of the tolerance, and in a stiff contact an error of the place
 * comes back as one of velocity. In a run of more steps, such as one that rattles all the time, as
 * many errors add up as it has steps. Whatever the tolerance, it is no more than {@link #PART} of
 * what the hidden thing does to the scene ({@code effect}): beyond that, a user takes the motion
 * for another one.
 *
 * @param column name of the column
 * @param value the right value
 * @param spread change of the value by one error of the tolerances in each state
 * @param effect change of the value by the thing that a step could pass over; positive
 * @param known error of the value itself, relative to it and to the effect
 */
record Expected(String column, double value, double spread, double effect, double known) {
  /** Errors of one tolerance each that may add up, worst case. */
  static final double STEPS = 1000;

  /** Largest part of the effect that may be wrong. */
  static final double PART = 0.05;

  /**
   * Errors of the references themselves, relative to the value and the effect: a depth of 10 µm at
   * a place of 50 m is known to 1e-9 of itself, and so is the time in contact.
   */
  private static final double REFERENCE = 1e-7;

  Expected(String column, double value, double spread, double effect) {
    this(column, value, spread, effect, REFERENCE);
  }

  /** Returns the same of a value that is known less well. */
  Expected known(double error) {
    return new Expected(column, value, spread, effect, error);
  }

  /** Returns the same of a column that counts from elsewhere. */
  Expected plus(double offset) {
    return new Expected(column, value + offset, spread, effect, known);
  }

  /** Returns the largest error that is right in a run of some steps. */
  double bound(long steps) {
    double own = known * (Math.abs(value) + effect);
    return Math.max(own, Math.min(Math.max(STEPS, (double) steps) * spread, PART * effect));
  }

  /**
   * Returns whether the effect stands out of the errors that some thirty steps leave; else a run
   * may pass it over, since it is as good as nothing beside the tolerances.
   */
  boolean standsOut() {
    return PART * effect > 30 * spread;
  }

  /** Returns the error of a value, where 1 is the largest that is right. */
  double error(double actual, long steps) {
    double error = Math.abs(actual - value) / bound(steps);
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }
}
