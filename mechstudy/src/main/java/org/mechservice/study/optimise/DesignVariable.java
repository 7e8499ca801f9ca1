package org.mechservice.study.optimise;

/**
 * A parameter that an optimiser may change, between its bounds.
 *
 * @param name the parameter's name in the model
 * @param lower smallest value, in the parameter's unit
 * @param upper largest value
 * @param start first value
 */
public record DesignVariable(String name, double lower, double upper, double start) {
  /**
   * @throws IllegalArgumentException if the bounds are no interval, or the start lies outside
   */
  public DesignVariable {
    if (!(Double.isFinite(lower) && Double.isFinite(upper) && lower < upper)) {
      throw new IllegalArgumentException(
          "the bounds of "
              + name
              + " are "
              + lower
              + " and "
              + upper
              + "; write two numbers, the smaller one first");
    }
    if (!(start >= lower && start <= upper)) {
      throw new IllegalArgumentException(
          "the start value "
              + start
              + " of "
              + name
              + " is not between "
              + lower
              + " and "
              + upper);
    }
  }

  /** Returns the variable with its start in the middle of its bounds. */
  public static DesignVariable between(String name, double lower, double upper) {
    return new DesignVariable(name, lower, upper, lower + (upper - lower) / 2);
  }

  /** Returns the variable with another first value; one outside the bounds is moved to them. */
  DesignVariable startingAt(double value) {
    return new DesignVariable(name, lower, upper, Math.max(lower, Math.min(upper, value)));
  }

  /** Returns the value at a part of the way from the lower bound (0) to the upper one (1). */
  public double value(double part) {
    double clipped = Math.max(0, Math.min(1, part));
    return clipped == 1 ? upper : lower + clipped * (upper - lower);
  }

  /** Returns which part of the way from the lower to the upper bound a value is. */
  public double part(double value) {
    return (value - lower) / (upper - lower);
  }
}
