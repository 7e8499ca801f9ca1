package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.PivotedElimination;

/**
 * The free directions of loops at a state: x = R x_I with J x = 0; pivoting chooses the independent
 * velocities x_I, one per degree of freedom.
 */
public final class FreeDirections {
  private final EquationsOfMotion equations;
  private final int n;
  private final int rank;

  /** Velocities of the state that are independent and dependent. */
  public final int[] independent;

  private final int[] dependent;
  private final int[] kept;

  /** R, n × f row by row. */
  public final double[] r;

  private final DenseLu lu;
  private final double[] column;

  /** Chooses directions at the placed state of the equations, whose J must be evaluated. */
  public FreeDirections(EquationsOfMotion equations) {
    this(equations, false);
  }

  /**
   * Returns the directions in which positions are free: those of the velocities, and those that
   * only non-holonomic equations forbid. The equations are placed as for the constructor.
   */
  public static FreeDirections ofPositions(EquationsOfMotion equations) {
    return new FreeDirections(equations, true);
  }

  private FreeDirections(EquationsOfMotion equations, boolean ofPositions) {
    this.equations = equations;
    n = equations.nv;
    if (ofPositions) {
      equations.jacobian.decomposeOfPositions();
    } else {
      equations.jacobian.decompose();
    }
    rank = equations.loops.holonomicCount() == 0 && ofPositions ? 0 : equations.rank();
    PivotedElimination elimination = new PivotedElimination(equations.lambda.length, n);
    elimination.eliminate(equations.jacobian.elements(), rank);
    independent = new int[n - rank];
    dependent = new int[rank];
    kept = new int[rank];
    for (int i = 0; i < rank; i++) {
      dependent[i] = elimination.column(i);
      kept[i] = elimination.row(i);
    }
    boolean[] isDependent = new boolean[n];
    for (int j : dependent) {
      isDependent[j] = true;
    }
    int next = 0;
    for (int j = 0; j < n; j++) {
      if (!isDependent[j]) {
        independent[next++] = j;
      }
    }
    lu = new DenseLu(rank);
    column = new double[rank];
    r = new double[n * (n - rank)];
    factor();
    formDirections();
  }

  private void factor() {
    double[] block = new double[rank * rank];
    for (int i = 0; i < rank; i++) {
      for (int j = 0; j < rank; j++) {
        block[i * rank + j] = equations.jacobian.elements()[kept[i] * n + dependent[j]];
      }
    }
    if (lu.factor(block) != LinearSolver.NONSINGULAR) {
      throw new IllegalStateException("pivots were found, but the block is singular");
    }
  }

  private void formDirections() {
    LoopEquations loops = equations.loops;
    double[] rows = new double[equations.lambda.length];
    double[] direction = new double[n];
    for (int j = 0; j < freedom(); j++) {
      for (int row = 0; row < rows.length; row++) {
        rows[row] = loops.jacobian.get(row, independent[j]);
      }
      complete(rows, direction);
      direction[independent[j]] = 1;
      for (int i = 0; i < n; i++) {
        r[i * freedom() + j] = direction[i];
      }
    }
  }

  /** Returns the rows of J that are independent. */
  public int[] kept() {
    return kept;
  }

  /** Returns the number of freedoms. */
  public int freedom() {
    return n - rank;
  }

  /**
   * Finds the dependent velocities with J x + rows = 0 for zero independent velocities.
   *
   * @param rows one number per equation; not modified
   * @param x n numbers; overwritten
   */
  public void complete(double[] rows, double[] x) {
    for (int i = 0; i < rank; i++) {
      column[i] = -rows[kept[i]] / equations.loops.size(kept[i]);
    }
    lu.solve(column);
    Arrays.fill(x, 0);
    for (int i = 0; i < rank; i++) {
      x[dependent[i]] = column[i] * equations.unit[dependent[i]];
    }
  }

  /** Writes R x_I. */
  public void expand(double[] reduced, double[] x) {
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int j = 0; j < freedom(); j++) {
        sum += r[i * freedom() + j] * reduced[j];
      }
      x[i] = sum;
    }
  }

  /** Writes Rᵀ x. */
  public void project(double[] x, double[] reduced) {
    for (int j = 0; j < freedom(); j++) {
      double sum = 0;
      for (int i = 0; i < n; i++) {
        sum += r[i * freedom() + j] * x[i];
      }
      reduced[j] = sum;
    }
  }

  /** Returns Rᵀ A B, f × columns, with A n × n and B n × columns. */
  public double[] reduce(double[] a, double[] b, int columns) {
    int f = freedom();
    double[] product = new double[f * columns];
    double[] ab = new double[n];
    double[] reduced = new double[f];
    for (int j = 0; j < columns; j++) {
      for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 0; k < n; k++) {
          sum += a[i * n + k] * b[k * columns + j];
        }
        ab[i] = sum;
      }
      project(ab, reduced);
      for (int i = 0; i < f; i++) {
        product[i * columns + j] = reduced[i];
      }
    }
    return product;
  }
}
