package org.mechservice.solver.closure.assembly;

import java.util.OptionalDouble;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.spectrum.SingularValues;

/** Least solution by singular values. */
final class DenseLeastMoves implements LeastMoves {
  /** Singular values below this fraction of the largest are taken as zero. */
  private static final double NEGLIGIBLE = 1e-9;

  private final SingularValues singular;
  private final int most;
  private final int columns;
  private final double[] dense;

  /**
   * @param columns number of leading columns of the matrix that are used
   */
  DenseLeastMoves(int rows, int columns) {
    singular = new SingularValues(rows, columns);
    most = Math.min(rows, columns);
    this.columns = columns;
    dense = new double[rows * columns];
  }

  @Override
  public void take(SparseMatrix matrix) {
    matrix.toDense(dense, columns);
    singular.decompose(dense);
  }

  @Override
  public void solve(double damping, double[] right, double[] x) {
    if (damping > 0) {
      double largest = singular.value(0);
      singular.solveDamped(damping * largest * largest, right, x);
    } else {
      singular.solve(rank(), right, x);
    }
  }

  @Override
  public OptionalDouble largestOverSmallest() {
    int rank = rank();
    return OptionalDouble.of(rank == 0 ? 1 : singular.value(0) / singular.value(rank - 1));
  }

  @Override
  public void solveTransposed(double[] right, double[] x) {
    singular.solveTransposed(rank(), right, x);
  }

  private int rank() {
    int rank = 0;
    while (rank < most && singular.value(rank) > NEGLIGIBLE * singular.value(0)) {
      rank++;
    }
    return rank;
  }
}
