package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.PivotedElimination;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.SparseLu;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The free directions of loops at a state: x = R x_I with J x = 0; pivoting chooses the independent
 * velocities x_I, one per degree of freedom. Large mechanisms have it done by sparse elimination,
 * and products with R take its elements that are not zero alone.
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

  /** Where the elements of each row of R that are not zero begin, and their columns. */
  private final int[] start;

  private final int[] columnOf;
  private final Solver block;
  private final double[] column;

  /** Solves equations of the kept rows for the dependent velocities. */
  private interface Solver {
    void solve(double[] b);
  }

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
    independent = new int[n - rank];
    dependent = new int[rank];
    kept = new int[rank];
    block = equations.loops.isLarge() ? chooseSparse() : chooseDense();
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
    column = new double[rank];
    r = new double[n * (n - rank)];
    formDirections();
    start = new int[n + 1];
    int[] columns = new int[r.length];
    for (int i = 0; i < n; i++) {
      start[i + 1] = start[i];
      for (int j = 0; j < freedom(); j++) {
        if (r[i * freedom() + j] != 0) {
          columns[start[i + 1]++] = j;
        }
      }
    }
    columnOf = Arrays.copyOf(columns, start[n]);
  }

  private Solver chooseDense() {
    double[] elements = equations.jacobian.elements();
    PivotedElimination elimination = new PivotedElimination(equations.lambda.length, n);
    elimination.eliminate(elements, rank);
    for (int i = 0; i < rank; i++) {
      dependent[i] = elimination.column(i);
      kept[i] = elimination.row(i);
    }
    double[] square = new double[rank * rank];
    for (int i = 0; i < rank; i++) {
      for (int j = 0; j < rank; j++) {
        square[i * rank + j] = elements[kept[i] * n + dependent[j]];
      }
    }
    DenseLu lu = new DenseLu(rank);
    require(lu.factor(square) == LinearSolver.NONSINGULAR);
    return lu::solve;
  }

  private Solver chooseSparse() {
    SparseMatrix scaled = equations.jacobian.scaled();
    SparseElimination elimination = new SparseElimination(scaled.rows(), n);
    require(elimination.eliminate(scaled, rank, 0) == rank);
    for (int i = 0; i < rank; i++) {
      dependent[i] = elimination.column(i);
      kept[i] = elimination.row(i);
    }
    double[] ones = new double[Math.max(scaled.rows(), n)];
    Arrays.fill(ones, 1);
    SparseLu lu = new SparseLu(elimination, rank, n);
    require(lu.factor(scaled, ones, ones));
    return lu::solve;
  }

  private static void require(boolean regular) {
    if (!regular) {
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
    block.solve(column);
    Arrays.fill(x, 0);
    for (int i = 0; i < rank; i++) {
      x[dependent[i]] = column[i] * equations.unit[dependent[i]];
    }
  }

  /** Writes R x_I. */
  public void expand(double[] reduced, double[] x) {
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int e = start[i]; e < start[i + 1]; e++) {
        sum += r[i * freedom() + columnOf[e]] * reduced[columnOf[e]];
      }
      x[i] = sum;
    }
  }

  /** Writes Rᵀ x. */
  public void project(double[] x, double[] reduced) {
    Arrays.fill(reduced, 0, freedom(), 0);
    for (int i = 0; i < n; i++) {
      for (int e = start[i]; e < start[i + 1]; e++) {
        reduced[columnOf[e]] += r[i * freedom() + columnOf[e]] * x[i];
      }
    }
  }

  /** Returns Rᵀ A B with A n × n and the directions B, f × the freedoms of B. */
  public double[] reduce(double[] a, FreeDirections b) {
    return reduce(a, b::addMultiple, b.freedom());
  }

  /** Returns Rᵀ A B, f × columns, with A n × n and B n × columns. */
  public double[] reduce(double[] a, double[] b, int columns) {
    Rows ofB =
        (k, factor, row) -> {
          for (int j = 0; j < columns; j++) {
            row[j] += factor * b[k * columns + j];
          }
        };
    return reduce(a, ofB, columns);
  }

  /** The rows of a matrix. */
  private interface Rows {
    /** Adds a multiple of row k. */
    void add(int k, double factor, double[] sum);
  }

  private double[] reduce(double[] a, Rows b, int columns) {
    double[] product = new double[freedom() * columns];
    double[] row = new double[columns];
    for (int i = 0; i < n; i++) {
      Arrays.fill(row, 0);
      for (int k = 0; k < n; k++) {
        double element = a[i * n + k];
        if (element != 0) {
          b.add(k, element, row);
        }
      }
      addRow(i, row, product);
    }
    return product;
  }

  /** Adds a multiple of row k of R. */
  private void addMultiple(int k, double factor, double[] sum) {
    for (int e = start[k]; e < start[k + 1]; e++) {
      sum[columnOf[e]] += factor * r[k * freedom() + columnOf[e]];
    }
  }

  /** Adds to Rᵀ A B what row i of A B gives. */
  private void addRow(int i, double[] row, double[] product) {
    for (int e = start[i]; e < start[i + 1]; e++) {
      int to = columnOf[e];
      double element = r[i * freedom() + to];
      for (int j = 0; j < row.length; j++) {
        product[to * row.length + j] += element * row[j];
      }
    }
  }
}
