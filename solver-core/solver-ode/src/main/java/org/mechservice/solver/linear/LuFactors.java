package org.mechservice.solver.linear;

/**
 * Common part of the factorisations P A = L U: whether there are factors to solve with, and the
 * estimate of the condition from solutions with A and its transpose.
 */
abstract class LuFactors implements LinearSolver {
  private final MatrixLayout layout;
  private final InverseNorm inverseNorm;
  private double norm;
  private boolean regular;

  LuFactors(MatrixLayout layout) {
    this.layout = layout;
    inverseNorm = new InverseNorm(layout.dimension());
  }

  /**
   * Copies a matrix to where it is factored.
   *
   * @return its largest row sum of absolute values
   */
  abstract double load(double[] matrix);

  /** Factors the matrix loaded; returns as {@link #factor}. */
  abstract int eliminate();

  /** Solves A x = b in place. */
  abstract void substitute(double[] b);

  /** Solves Aᵀ x = b in place. */
  abstract void substituteTransposed(double[] b);

  @Override
  public final MatrixLayout layout() {
    return layout;
  }

  @Override
  public final int factor(double[] matrix) {
    if (matrix.length != layout.length()) {
      throw new IllegalArgumentException(
          "the matrix has " + matrix.length + " elements; it must have " + layout.length());
    }
    norm = load(matrix);
    int pivot = eliminate();
    regular = pivot == NONSINGULAR;
    return pivot;
  }

  @Override
  public final void solve(double[] b) {
    requireRegular();
    substitute(b);
  }

  /**
   * Solves Aᵀ x = b.
   *
   * @param b right-hand side, length {@code layout().dimension()}; overwritten with x
   * @throws IllegalStateException if no matrix was factored or the last one is singular
   */
  public final void solveTransposed(double[] b) {
    requireRegular();
    substituteTransposed(b);
  }

  @Override
  public final double reciprocalCondition() {
    if (!regular) {
      return 0;
    }
    if (layout.dimension() == 0) {
      return 1;
    }
    double reciprocal = 1 / norm / inverseNorm.of(this);
    return reciprocal > 0 ? Math.min(1, reciprocal) : 0;
  }

  private void requireRegular() {
    if (!regular) {
      throw new IllegalStateException(
          "no factors to solve with: factor was not called, or the matrix is singular");
    }
  }

  /** Returns whether a number and its reciprocal are finite. */
  static boolean isPivot(double candidate) {
    return Math.abs(candidate) >= Double.MIN_NORMAL && Double.isFinite(candidate);
  }
}
