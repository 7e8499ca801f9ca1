package org.mechservice.solver.closure.assembly;

import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.linear.SingularValues;

/**
 * J of the loops with its rows over the sizes of what they measure and its columns in units, by its
 * singular values: what has one right answer although equations may repeat each other or positions
 * be singular. Workspace of one thread; nothing allocates after construction.
 */
public final class ScaledJacobian {
  /** Singular values below this part of the largest are not divided by: a singular position. */
  private static final double NEGLIGIBLE = 1e-10;

  private final LoopEquations loops;
  private final double[] unit;
  private final SingularValues singular;
  private final double[] scaled;
  private final double[] ofVelocities;
  private final double[] ofRows;

  /**
   * @param unit of each velocity of the state: 1, or a length of the mechanism in m; kept
   */
  public ScaledJacobian(LoopEquations loops, double[] unit) {
    this.loops = loops;
    this.unit = unit;
    singular = new SingularValues(loops.count(), unit.length);
    scaled = new double[loops.count() * unit.length];
    ofVelocities = new double[unit.length];
    ofRows = new double[loops.count()];
  }

  /** Takes the J that the loops have now. */
  public void decompose() {
    loops.jacobian.toDense(scaled, unit.length);
    for (int row = 0; row < ofRows.length; row++) {
      for (int j = 0; j < unit.length; j++) {
        scaled[row * unit.length + j] = scaled[row * unit.length + j] * unit[j] / loops.size(row);
      }
    }
    singular.decompose(scaled);
  }

  /** Returns the number of independent equations, {@code most} at most. */
  public int rank(int most) {
    int rank = 0;
    while (rank < Math.min(most, Math.min(ofRows.length, unit.length))
        && singular.value(rank) > NEGLIGIBLE * singular.value(0)) {
      rank++;
    }
    return rank;
  }

  /** Returns singular value {@code k} over the largest. */
  public double relative(int k) {
    return singular.value(k) / singular.value(0);
  }

  /** Returns the scaled J, row by row, one number per velocity of the state; not to be modified. */
  public double[] elements() {
    return scaled;
  }

  /**
   * Finds the multipliers with Jᵀ λ = −residual, those of least norm, forces being counted times
   * the mechanism's length to compare with moments.
   *
   * @param residual one number per velocity; not modified
   * @param lambda one number per equation; overwritten
   */
  public void multipliers(int rank, double[] residual, double[] lambda) {
    for (int j = 0; j < unit.length; j++) {
      ofVelocities[j] = -residual[j] * unit[j];
    }
    singular.solveTransposed(rank, ofVelocities, lambda);
    for (int row = 0; row < lambda.length; row++) {
      lambda[row] /= loops.size(row);
    }
  }

  /**
   * Finds the smallest change with J x = −rows.
   *
   * @param rows one number per equation; not modified
   * @param x one number per velocity; overwritten
   */
  public void change(int rank, double[] rows, double[] x) {
    for (int row = 0; row < ofRows.length; row++) {
      ofRows[row] = -rows[row] / loops.size(row);
    }
    singular.solve(rank, ofRows, x);
    for (int j = 0; j < unit.length; j++) {
      x[j] *= unit[j];
    }
  }
}
