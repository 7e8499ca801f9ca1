package org.mechservice.solver.force.law;

/** What a law needs of a coefficient, besides being finite. */
public enum Condition {
  FINITE("finite"),
  NOT_NEGATIVE("zero or positive"),
  POSITIVE("positive"),
  AT_LEAST_ONE("at least 1"),
  ZERO_ON_ONE_SIDE("zero for a force that acts on one side only"),
  /** Follows a coefficient of friction. */
  POSITIVE_WITH_FRICTION("positive where there is friction");

  private final String text;

  Condition(String text) {
    this.text = text;
  }

  /** Returns it in words, after "must be". */
  public String text() {
    return text;
  }

  /**
   * Returns whether it holds.
   *
   * @param before the coefficient before this one
   */
  public boolean holds(double value, double before) {
    return switch (this) {
      case FINITE -> true;
      case NOT_NEGATIVE -> value >= 0;
      case POSITIVE -> value > 0;
      case AT_LEAST_ONE -> value >= 1;
      case ZERO_ON_ONE_SIDE -> value == 0;
      case POSITIVE_WITH_FRICTION -> value > 0 || (value == 0 && before == 0);
    };
  }
}
