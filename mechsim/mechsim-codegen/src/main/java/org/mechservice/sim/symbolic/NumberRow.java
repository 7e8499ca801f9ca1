package org.mechservice.sim.symbolic;

import java.util.Arrays;

/**
 * Numbers in a fixed order, of which a program picks one by a computed index: the points of a
 * table. Code holds them as an array; two rows of the same numbers are equal. Immutable.
 */
public final class NumberRow {
  private final double[] numbers;
  private final int hash;

  /**
   * Creates a row.
   *
   * @param numbers the numbers, finite; not modified
   */
  public NumberRow(double... numbers) {
    this.numbers = numbers.clone();
    this.hash = Arrays.hashCode(numbers);
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
    return other instanceof NumberRow row && Arrays.equals(numbers, row.numbers);
  }

  @Override
  public int hashCode() {
    return hash;
  }

  /** Returns the result of a function that reads this row. */
  double value(MathFunction function, double... arguments) {
    return function.value(numbers, arguments);
  }
}
