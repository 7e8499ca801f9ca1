package org.mechservice.solver.closure.assembly;

import java.util.Optional;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * The scaled loop Jacobian and its singular values: rows are divided by the sizes of what they
 * measure, columns are in units. Least-norm solutions are unique even with redundant equations and
 * in singular positions. Large mechanisms get them from sparse factors. Workspace of one thread;
 * only singular values of large mechanisms allocate after construction.
 */
public final class ScaledJacobian {
  /**
   * Singular values below this fraction of the largest are taken as zero, as in a singular
   * position.
   */
  public static final double NEGLIGIBLE = 1e-10;

  private final LoopEquations loops;
  private final double[] unit;
  private final SparseMatrix scaled;
  private final Optional<SparseLeastMoves> sparse;
  private Optional<SingularValues> singular = Optional.empty();
  private double[] elements = {};

  /** Whether the singular values belong to the present J. */
  private boolean decomposed;

  private final double[] ofVelocities;
  private final double[] ofRows;

  /**
   * @param unit of each velocity of the state: 1, or a length of the mechanism in m; kept
   */
  public ScaledJacobian(LoopEquations loops, double[] unit) {
    this.loops = loops;
    this.unit = unit;
    scaled = loops.jacobian.sameShape();
    sparse =
        loops.isLarge() ? Optional.of(new SparseLeastMoves(scaled, unit.length)) : Optional.empty();
    ofVelocities = new double[unit.length];
    ofRows = new double[loops.count()];
  }

  /** Copies and scales the present J of the loops. */
  public void decompose() {
    decompose(false);
  }

  /** As {@link #decompose()}, with zeros in place of non-holonomic equations. */
  public void decomposeOfPositions() {
    decompose(true);
  }

  private void decompose(boolean ofPositions) {
    for (int row = 0; row < ofRows.length; row++) {
      for (int e = scaled.start[row]; e < scaled.start[row + 1]; e++) {
        int j = scaled.column[e];
        boolean counts = j < unit.length && (loops.isHolonomic(row) || !ofPositions);
        scaled.value[e] = counts ? loops.jacobian.value[e] * unit[j] / loops.size(row) : 0;
      }
    }
    decomposed = false;
    sparse.ifPresentOrElse(least -> least.take(scaled), this::values);
  }

  /** Returns the singular values of the last copied J. */
  private SingularValues values() {
    if (singular.isEmpty()) {
      singular = Optional.of(new SingularValues(loops.count(), unit.length));
    }
    if (!decomposed) {
      singular.get().decompose(elements());
      decomposed = true;
    }
    return singular.get();
  }

  /** Returns the number of independent equations, at most {@code most}. */
  public int rank(int most) {
    if (sparse.isPresent()) {
      return Math.min(most, new SparseIndependentRows(scaled, unit.length).rank());
    }
    int rank = 0;
    while (rank < Math.min(most, Math.min(ofRows.length, unit.length))
        && values().value(rank) > NEGLIGIBLE * values().value(0)) {
      rank++;
    }
    return rank;
  }

  /** Returns singular value {@code k} over the largest. */
  public double relative(int k) {
    return values().value(k) / values().value(0);
  }

  /**
   * Returns the scaled J, row by row, one number per velocity of the state; must not be modified.
   */
  public double[] elements() {
    if (elements.length < ofRows.length * unit.length) {
      elements = new double[ofRows.length * unit.length];
    }
    scaled.toDense(elements, unit.length);
    return elements;
  }

  /** Returns the scaled J, of which the columns of the state's velocities count; not modified. */
  public SparseMatrix scaled() {
    return scaled;
  }

  /**
   * Finds the multipliers of least norm with Jᵀ λ = −residual; forces are multiplied by the
   * mechanism's length to compare them with moments.
   *
   * @param most number of independent equations at most
   * @param residual one number per velocity; not modified
   * @param lambda one number per equation; overwritten
   */
  public void multipliers(int most, double[] residual, double[] lambda) {
    for (int j = 0; j < unit.length; j++) {
      ofVelocities[j] = -residual[j] * unit[j];
    }
    if (sparse.isPresent()) {
      sparse.get().solveTransposed(ofVelocities, lambda);
    } else {
      values().solveTransposed(rank(most), ofVelocities, lambda);
    }
    for (int row = 0; row < lambda.length; row++) {
      lambda[row] /= loops.size(row);
    }
  }

  /**
   * Finds the smallest change with J x = −rows.
   *
   * @param most number of independent equations at most
   * @param rows one number per equation; not modified
   * @param x one number per velocity; overwritten
   */
  public void change(int most, double[] rows, double[] x) {
    for (int row = 0; row < ofRows.length; row++) {
      ofRows[row] = -rows[row] / loops.size(row);
    }
    if (sparse.isPresent()) {
      sparse.get().solve(0, ofRows, x);
    } else {
      values().solve(rank(most), ofRows, x);
    }
    for (int j = 0; j < unit.length; j++) {
      x[j] *= unit[j];
    }
  }
}
