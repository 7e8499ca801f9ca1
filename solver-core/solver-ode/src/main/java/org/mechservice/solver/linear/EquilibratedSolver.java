package org.mechservice.solver.linear;

/**
 * Brings the rows of a matrix to like size before another solver factors it, so that the units of
 * the equations do not decide about pivots and condition. The factors are powers of 2: nothing is
 * rounded.
 */
public final class EquilibratedSolver implements LinearSolver {
  private final LinearSolver solver;

  /** Elements of the scaled matrix, by the solver's layout. */
  private final double[] scaled;

  /** Factor of each row, length n. */
  private final double[] scale;

  /**
   * @param solver factors the scaled matrix
   */
  public EquilibratedSolver(LinearSolver solver) {
    this.solver = solver;
    scaled = new double[solver.layout().length()];
    scale = new double[solver.layout().dimension()];
  }

  @Override
  public MatrixLayout layout() {
    return solver.layout();
  }

  @Override
  public int factor(double[] matrix) {
    if (matrix.length != scaled.length) {
      return solver.factor(matrix);
    }
    MatrixLayout layout = solver.layout();
    findScales(layout, matrix);
    for (int j = 0; j < scale.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        int ij = layout.index(i, j);
        scaled[ij] = scale[i] * matrix[ij];
      }
    }
    return solver.factor(scaled);
  }

  /** Rows get a largest element from 1 to 2; one that is zero or not finite stays as it is. */
  private void findScales(MatrixLayout layout, double[] matrix) {
    for (int i = 0; i < scale.length; i++) {
      scale[i] = 0;
    }
    for (int j = 0; j < scale.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        scale[i] = Math.max(scale[i], Math.abs(matrix[layout.index(i, j)]));
      }
    }
    for (int i = 0; i < scale.length; i++) {
      boolean usable = scale[i] >= Double.MIN_NORMAL && Double.isFinite(scale[i]);
      scale[i] = usable ? Math.scalb(1.0, -Math.getExponent(scale[i])) : 1;
    }
  }

  @Override
  public void solve(double[] b) {
    for (int i = 0; i < scale.length; i++) {
      b[i] *= scale[i];
    }
    solver.solve(b);
  }

  /** {@inheritDoc} It is that of the scaled matrix: the unit of each row does not matter. */
  @Override
  public double reciprocalCondition() {
    return solver.reciprocalCondition();
  }
}
