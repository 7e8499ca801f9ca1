package org.mechservice.solver.linear;

/**
 * A band around the diagonal, row after row: A_ij at i (l + u + 1) + j − i + l for −l ≤ j − i ≤ u.
 * The corners of the band that lie outside of the matrix have their places too and are not used.
 *
 * @param dimension n, not negative
 * @param lower l, number of diagonals below the main one, from 0 to n − 1
 * @param upper u, number of diagonals above the main one, from 0 to n − 1
 */
public record BandLayout(int dimension, int lower, int upper) implements MatrixLayout {
  /**
   * @throws IllegalArgumentException if the dimension is negative or the band wider than the matrix
   */
  public BandLayout {
    if (dimension < 0) {
      throw new IllegalArgumentException(
          "the dimension of a matrix is " + dimension + "; it must not be negative");
    }
    requireInside("below", lower, dimension);
    requireInside("above", upper, dimension);
  }

  private static void requireInside(String side, int diagonals, int dimension) {
    int most = Math.max(0, dimension - 1);
    if (diagonals < 0 || diagonals > most) {
      throw new IllegalArgumentException(
          "the number of diagonals "
              + side
              + " the main one is "
              + diagonals
              + "; it must be from 0 to "
              + most);
    }
  }

  @Override
  public int length() {
    return dimension * columnDistance();
  }

  @Override
  public int firstRow(int column) {
    return Math.max(0, column - upper);
  }

  @Override
  public int lastRow(int column) {
    return Math.min(dimension - 1, column + lower);
  }

  @Override
  public int index(int row, int column) {
    return row * columnDistance() + column - row + lower;
  }

  @Override
  public int columnDistance() {
    return lower + upper + 1;
  }
}
