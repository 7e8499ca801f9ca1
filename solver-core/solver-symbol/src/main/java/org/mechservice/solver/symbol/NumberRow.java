package org.mechservice.solver.symbol;

import java.util.Arrays;

/**
 * Numbers in a fixed order, of which a program picks one by a computed index: the points of a
 * table. Code holds them as an array; two rows of the same numbers are equal. Immutable.
 *
 * <p>A row that divides the arguments of a table may tell at which of them the slope jumps; rows
 * that tell otherwise are not equal.
 */
public final class NumberRow implements FixedPart {
  private final double[] numbers;
  private final double[] corners;
  private final int hash;

  /**
   * Creates a row.
   *
   * @param numbers the numbers, finite; not modified
   */
  public NumberRow(double... numbers) {
    this(numbers, new double[0]);
  }

  private NumberRow(double[] numbers, double[] corners) {
    this.numbers = numbers.clone();
    this.corners = corners.clone();
    this.hash = 31 * Arrays.hashCode(numbers) + Arrays.hashCode(corners);
  }

  /**
   * Returns the row of the points of a table.
   *
   * @param knots ascending; not modified
   * @param corners those at which the slope jumps, ascending; not modified
   */
  public static NumberRow ofKnots(double[] knots, double[] corners) {
    return new NumberRow(knots, corners);
  }

  /** Returns the numbers at which the slope of what is chosen by this row jumps; a copy. */
  public double[] corners() {
    return corners.clone();
  }

  /** Returns how many there are. */
  public int size() {
    return numbers.length;
  }

  /** Returns number {@code index}. */
  public double at(int index) {
    return numbers[index];
  }

  /** Returns whether all of them are the same. */
  boolean isConstant() {
    for (double number : numbers) {
      if (number != numbers[0]) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof NumberRow row
        && Arrays.equals(numbers, row.numbers)
        && Arrays.equals(corners, row.corners);
  }

  @Override
  public int hashCode() {
    return hash;
  }

  /** Returns the numbers, which must not be modified. */
  double[] numbers() {
    return numbers;
  }

  /** Returns the result of a function that reads this row. */
  double value(MathFunction function, double... arguments) {
    return function.value(numbers, arguments);
  }
}
