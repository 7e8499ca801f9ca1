package org.mechservice.solver.closure.model;

import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.SparseMatrix;

/** Dense factors of J U² Jᵀ, which are fast for small mechanisms. */
final class DensePositionCorrection implements PositionCorrection {
  private final SparseMatrix rows;
  private final double[] units;
  private final int m;
  private final double[] weighted;
  private final double[] square;
  private final Cholesky cholesky;

  /**
   * Makes a workspace.
   *
   * @param rows J, to be written before each {@link #factor}
   * @param units U of the columns
   */
  DensePositionCorrection(SparseMatrix rows, double[] units) {
    this.rows = rows;
    this.units = units;
    m = rows.rows();
    weighted = new double[units.length];
    square = new double[m * m];
    cholesky = new Cholesky(m);
  }

  @Override
  public boolean factor() {
    double largest = 0;
    for (int i = 0; i < m; i++) {
      for (int e = rows.start[i]; e < rows.start[i + 1]; e++) {
        int k = rows.column[e];
        weighted[k] = rows.value[e] * units[k] * units[k];
      }
      for (int j = 0; j <= i; j++) {
        square[i * m + j] = rows.product(j, weighted, 0);
      }
      largest = Math.max(largest, square[i * m + i]);
      for (int e = rows.start[i]; e < rows.start[i + 1]; e++) {
        weighted[rows.column[e]] = 0;
      }
    }
    double regular = PositionCorrection.regularPart(largest);
    for (int i = 0; i < m; i++) {
      square[i * m + i] += regular;
    }
    return m == 0 || cholesky.factor(square) < 0;
  }

  @Override
  public void solve(double[] b) {
    cholesky.solve(b, 0);
  }
}
