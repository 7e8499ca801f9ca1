package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Corrections for few loops of long chains, where A is eliminated from link to link and never
 * formed: (J A⁻¹ Jᵀ + 1/α) Δλ = J A⁻¹ f + g, Δx = A⁻¹ (f − Jᵀ Δλ). With m equations it takes O(n m
 * + m³) operations. Workspace of one thread.
 *
 * <p>α of a row is a multiple of the stiffness with which A resists its push, 1 / (J A⁻¹ Jᵀ) on the
 * diagonal, so that rows of any length lose equally many digits.
 */
public final class ArticulatedAugmentedEquations extends AugmentedEquations {
  private final ArticulatedIteration iteration;

  /** A⁻¹ Jᵀ, column by column. */
  private final double[][] pushed;

  private final double[] compliance;
  private final double[] product;
  private final DenseLu lu;

  /**
   * Makes equations.
   *
   * @param rows J, to be written before each factorisation; rows of zeros are permitted
   * @param units of the unknowns
   * @param iteration keeps A
   */
  public ArticulatedAugmentedEquations(
      SparseMatrix rows, double[] units, ArticulatedIteration iteration) {
    super(rows, units);
    this.iteration = iteration;
    pushed = new double[m][n];
    compliance = new double[m * m];
    product = new double[n];
    lu = new DenseLu(m);
  }

  /**
   * Factors the equations of the corrections, with A as last linearised and J as it has been
   * written.
   *
   * @param hGamma step for which A is eliminated, s
   * @param stiffness α of a row, as a multiple of the stiffness of A against its push
   * @return a negative number, or the unknown without a pivot
   */
  public int factor(double hGamma, double stiffness) {
    if (!iteration.factor(hGamma)) {
      return iteration.singularVelocity();
    }
    for (int row = 0; row < m; row++) {
      double[] push = pushed[row];
      Arrays.fill(push, 0);
      rows.addRow(row, 1, push, 0);
      iteration.solveReduced(push);
      for (int other = 0; other < m; other++) {
        compliance[other * m + row] = rows.product(other, push, 0);
      }
    }
    for (int row = 0; row < m; row++) {
      double own = Math.abs(compliance[row * m + row]);
      penalties[row] = own > 0 ? stiffness / own : 1;
      compliance[row * m + row] += 1 / penalties[row];
    }
    int failed = lu.factor(compliance);
    return failed == LinearSolver.NONSINGULAR ? failed : unknownOf(failed);
  }

  /** Returns the unknown that a row moves most. */
  private int unknownOf(int row) {
    int most = 0;
    double largest = -1;
    for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
      double part = Math.abs(rows.value[e]) * units[rows.column[e]];
      if (part > largest) {
        largest = part;
        most = rows.column[e];
      }
    }
    return most;
  }

  @Override
  void correct(double[] force, double[] gap) {
    iteration.solveReduced(force);
    for (int row = 0; row < m; row++) {
      gap[row] += rows.product(row, force, 0);
    }
    lu.solve(gap);
    for (int row = 0; row < m; row++) {
      for (int j = 0; j < n; j++) {
        force[j] -= gap[row] * pushed[row][j];
      }
    }
  }

  @Override
  void subtractProduct(double[] x, int at, double[] force) {
    System.arraycopy(x, at, product, 0, n);
    iteration.addMatrixProduct(-1, product, force);
  }
}
