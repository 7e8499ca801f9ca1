package org.mechservice.solver.symbol;

/**
 * What the search of steps must know of a step f(a) or f(a, b) on one or two earlier values: an
 * operation of arithmetic, a {@link MathFunction}, or the curve or map of a table.
 */
public interface WatchedStep {
  /** Returns the name in printed code. */
  String name();

  /** Finds the bounds of f, with its rounding, for a and b in two intervals. */
  void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out);

  /** Returns whether it is made of pieces that meet in corners or jumps. */
  boolean hasPieces();

  /** Returns the number of the piece that f takes; neighbours have neighbouring ones. */
  double piece(double a, double b);

  /** Returns how far a and b are from where the piece ends. */
  double distance(double a, double b);

  /** Returns whether f can change much while a and b hardly do, without a corner. */
  boolean isNarrow();

  /**
   * Returns whether f stays near a parabola through three of its values for a and b in two
   * intervals.
   *
   * @param highest the highest value of f there
   */
  boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest);
}
