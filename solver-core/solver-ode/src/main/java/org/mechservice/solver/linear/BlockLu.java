package org.mechservice.solver.linear;

import java.util.function.IntFunction;

/** Factors of a matrix of blocks on the diagonal: each block is factored and solved by itself. */
public final class BlockLu implements LinearSolver {
  private final BlockLayout layout;
  private final LinearSolver[] solvers;

  /** Elements, and right-hand side, of one block. */
  private final double[][] elements;

  private final double[][] sides;

  /**
   * @param solver returns a solver for dense matrices of a dimension
   */
  public BlockLu(BlockLayout layout, IntFunction<LinearSolver> solver) {
    this.layout = layout;
    solvers = new LinearSolver[layout.blocks()];
    elements = new double[solvers.length][];
    sides = new double[solvers.length][];
    for (int k = 0; k < solvers.length; k++) {
      int rows = layout.rows(k);
      solvers[k] = solver.apply(rows);
      elements[k] = new double[rows * rows];
      sides[k] = new double[rows];
    }
  }

  @Override
  public MatrixLayout layout() {
    return layout;
  }

  @Override
  public int factor(double[] matrix) {
    if (matrix.length != layout.length()) {
      throw new IllegalArgumentException(
          "the matrix has " + matrix.length + " elements; it must have " + layout.length());
    }
    int singular = NONSINGULAR;
    for (int k = 0; k < solvers.length; k++) {
      int first = k * layout.size();
      System.arraycopy(matrix, first * layout.size(), elements[k], 0, elements[k].length);
      int column = solvers[k].factor(elements[k]);
      if (column != NONSINGULAR && singular == NONSINGULAR) {
        singular = first + column;
      }
    }
    return singular;
  }

  @Override
  public void solve(double[] b) {
    for (int k = 0; k < solvers.length; k++) {
      int first = k * layout.size();
      System.arraycopy(b, first, sides[k], 0, sides[k].length);
      solvers[k].solve(sides[k]);
      System.arraycopy(sides[k], 0, b, first, sides[k].length);
    }
  }

  /** Returns the least one of the blocks. */
  @Override
  public double reciprocalCondition() {
    double least = 1;
    for (LinearSolver solver : solvers) {
      least = Math.min(least, solver.reciprocalCondition());
    }
    return least;
  }
}
