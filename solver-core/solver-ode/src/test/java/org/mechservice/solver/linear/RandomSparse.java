package org.mechservice.solver.linear;

import java.util.BitSet;
import java.util.Random;

/** Seeded sparse matrices with rows that repeat others. */
final class RandomSparse {
  private RandomSparse() {}

  /**
   * Returns a matrix whose rows have a few elements in a band of columns, the last rows being sums
   * of two others.
   *
   * @param repeated number of rows that follow from the others
   */
  static SparseMatrix of(long seed, int rows, int columns, int repeated) {
    Random random = new Random(seed);
    double[][] dense = new double[rows][columns];
    for (int i = 0; i < rows - repeated; i++) {
      for (int e = 0; e < 4; e++) {
        int j = Math.floorMod(i + random.nextInt(9) - 2, columns);
        dense[i][j] = 2 * random.nextDouble() - 1;
      }
      dense[i][i % columns] += 1;
    }
    for (int i = rows - repeated; i < rows; i++) {
      int first = random.nextInt(rows - repeated);
      int second = random.nextInt(rows - repeated);
      for (int j = 0; j < columns; j++) {
        dense[i][j] = dense[first][j] - 0.5 * dense[second][j];
      }
    }
    int[][] pattern = new int[rows][];
    for (int i = 0; i < rows; i++) {
      BitSet used = new BitSet();
      for (int j = 0; j < columns; j++) {
        if (dense[i][j] != 0) {
          used.set(j);
        }
      }
      pattern[i] = used.stream().toArray();
    }
    SparseMatrix matrix = SparseMatrix.of(pattern, columns);
    for (int i = 0; i < rows; i++) {
      matrix.setRow(i, dense[i], 0);
    }
    return matrix;
  }
}
