package org.mechservice.study.gradient;

import org.mechservice.study.Reduction;

/**
 * An output that is differentiated: a number that a reduction takes of a column.
 *
 * @param column which observed column
 * @param reduction what is taken of it; no series
 */
record GradientOutput(int column, Reduction reduction) {
  Reduction.Kind kind() {
    return reduction.kind();
  }

  /** Returns whether it is taken from an integral over the run. */
  boolean isIntegral() {
    return kind() == Reduction.Kind.INTEGRAL
        || kind() == Reduction.Kind.MEAN
        || kind() == Reduction.Kind.RMS;
  }

  /** Returns whether it is found between the steps. */
  boolean isFound() {
    return kind() == Reduction.Kind.MIN
        || kind() == Reduction.Kind.MAX
        || kind() == Reduction.Kind.CROSSING;
  }

  /** Returns what is integrated of the column's value. */
  double integrand(double value) {
    return kind() == Reduction.Kind.RMS ? value * value : value;
  }

  /** Returns the derivative of what is integrated by the column's value. */
  double integrandSlope(double value) {
    return kind() == Reduction.Kind.RMS ? 2 * value : 1;
  }

  /** Returns the number from the integral over a run of a length, s. */
  double ofIntegral(double integral, double length) {
    return switch (kind()) {
      case MEAN -> integral / length;
      case RMS -> Math.sqrt(Math.max(0, integral / length));
      default -> integral;
    };
  }

  /** Returns the derivative of the number by the integral. */
  double byIntegral(double integral, double length) {
    return switch (kind()) {
      case MEAN -> 1 / length;
      case RMS -> 1 / (2 * length * ofIntegral(integral, length));
      default -> 1;
    };
  }

  /** Returns the derivative of the number by the length of the run, the integral being fixed. */
  double byLength(double integral, double length) {
    return switch (kind()) {
      case MEAN, RMS -> -byIntegral(integral, length) * integral / length;
      default -> 0;
    };
  }
}
