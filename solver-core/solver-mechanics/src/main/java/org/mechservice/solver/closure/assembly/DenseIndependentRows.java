package org.mechservice.solver.closure.assembly;

import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.PivotedElimination;
import org.mechservice.solver.linear.spectrum.SingularValues;

/** Rank by singular values, independent rows by full pivoting. */
record DenseIndependentRows(int rank, List<Integer> redundant, double smallestPivot)
    implements IndependentRows {
  /**
   * @param matrix m × n, row after row; not modified
   */
  DenseIndependentRows(double[] matrix, int m, int n) {
    this(matrix, m, n, rank(matrix, m, n));
  }

  private DenseIndependentRows(double[] matrix, int m, int n, int rank) {
    this(matrix, m, rank, new PivotedElimination(m, n));
  }

  private DenseIndependentRows(double[] matrix, int m, int rank, PivotedElimination elimination) {
    this(
        rank,
        IntStream.range(elimination.eliminate(matrix, rank), m)
            .map(elimination::row)
            .sorted()
            .boxed()
            .toList(),
        elimination.lastOverFirst());
  }

  private static int rank(double[] matrix, int m, int n) {
    SingularValues singular = new SingularValues(m, n);
    singular.decompose(matrix);
    return singular.rank(GAP, NEGLIGIBLE);
  }
}
