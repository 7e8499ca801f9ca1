package org.mechservice.solver.linear;

/**
 * Square blocks on the diagonal, one after another, each row after row: the blocks have m rows, but
 * for the last one, which has what is left. A_ij is at k m² + (i − k m) r + j − k m in block k of r
 * rows.
 *
 * @param dimension n, not negative
 * @param size m, at least 1
 */
public record BlockLayout(int dimension, int size) implements MatrixLayout {
  /**
   * @throws IllegalArgumentException if the dimension is negative or the size is not positive
   */
  public BlockLayout {
    if (dimension < 0 || size < 1) {
      throw new IllegalArgumentException(
          "blocks of "
              + size
              + " rows in a matrix of dimension "
              + dimension
              + ": the size must be positive, the dimension not negative");
    }
  }

  /** Returns the number of blocks. */
  public int blocks() {
    return (dimension + size - 1) / size;
  }

  /** Returns the rows of a block. */
  public int rows(int block) {
    return Math.min(size, dimension - block * size);
  }

  @Override
  public int length() {
    int whole = dimension / size;
    int rest = dimension % size;
    return whole * size * size + rest * rest;
  }

  @Override
  public int firstRow(int column) {
    return column - column % size;
  }

  @Override
  public int lastRow(int column) {
    return Math.min(dimension, firstRow(column) + size) - 1;
  }

  @Override
  public int index(int row, int column) {
    int block = column / size;
    int first = block * size;
    return first * size + (row - first) * rows(block) + column - first;
  }

  @Override
  public int columnDistance() {
    return Math.max(1, Math.min(size, dimension));
  }
}
