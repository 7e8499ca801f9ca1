package org.mechservice.solver.linear.front;

/** What a front leaves to a later one: rows without a pivot first, then those of later groups. */
final class FrontRest {
  static final FrontRest NONE = new FrontRest(new int[0], 0, new double[0], new double[0]);

  /** Unknown of each row. */
  final int[] rows;

  /** Number of rows whose group has been eliminated, but without a pivot for them. */
  final int delayed;

  /** Elements, row by row. */
  final double[] matrix;

  /** Size of what each diagonal element was summed and subtracted from. */
  final double[] whole;

  FrontRest(int[] rows, int delayed, double[] matrix, double[] whole) {
    this.rows = rows;
    this.delayed = delayed;
    this.matrix = matrix;
    this.whole = whole;
  }
}
