package org.mechservice.solver.integration;

import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;

/** I − hγ J and its factors, where hγ = h / ((1 − κ_k) γ_k). */
final class IterationMatrix {
  private final LinearSolver solver;

  /** Elements by the solver's layout. */
  private final double[] matrix;

  private boolean factored;
  private int singularColumn;
  private long factorisations;
  private long solutions;

  IterationMatrix(LinearSolver solver) {
    this.solver = solver;
    matrix = new double[solver.layout().length()];
  }

  /** Forgets the factors: h, k or J has changed. */
  void outdate() {
    factored = false;
  }

  /** Returns whether the factors are those of the present h, k and J. */
  boolean factored() {
    return factored;
  }

  /** Factors the matrix. */
  Attempt factor(double hGamma, double[] jacobian) {
    MatrixLayout layout = solver.layout();
    for (int i = 0; i < matrix.length; i++) {
      matrix[i] = -hGamma * jacobian[i];
    }
    for (int i = 0; i < layout.dimension(); i++) {
      matrix[layout.index(i, i)] += 1;
    }
    singularColumn = solver.factor(matrix);
    factorisations++;
    factored = singularColumn == LinearSolver.NONSINGULAR;
    return factored ? Attempt.PASSED : Attempt.SINGULAR_MATRIX;
  }

  /** Solves in place. */
  void solve(double[] b) {
    solver.solve(b);
    solutions++;
  }

  /** Returns the column, and so the component, that left no pivot. */
  int singularColumn() {
    return singularColumn;
  }

  /** Returns whether round-off alone decides about the solutions. */
  boolean singularToWorkingPrecision() {
    return solver.reciprocalCondition() < Math.ulp(1.0);
  }

  long factorisations() {
    return factorisations;
  }

  long solutions() {
    return solutions;
  }
}
