package org.mechservice.solver.closure.model;

import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.SparseMatrix;

/** A step along loops with Rᵀ A R formed: for few degrees of freedom, or few velocities. */
final class DenseStepAlongLoops extends StepAlongLoops {
  private final Partition velocities;
  private final SparseMatrix jacobian;
  private final TreeIteration iteration;
  private final ProjectedMotion directions;

  /** A as a square matrix, n × n; empty if it is multiplied in its sparsity. */
  private final double[] full;

  /** Rᵀ A R, f × f. */
  final double[] reduced;

  private final double[] carried;
  private final DenseLu lu;

  /**
   * @param velocities partition of the velocities; factored by the caller
   * @param jacobian J of the linearisation
   * @param large whether A is multiplied in its sparsity
   */
  DenseStepAlongLoops(
      Partition velocities, SparseMatrix jacobian, TreeIteration iteration, boolean large) {
    this.iteration = iteration;
    this.velocities = velocities;
    this.jacobian = jacobian;
    int n = velocities.n;
    int f = velocities.freedom();
    directions = new ProjectedMotion(n, velocities);
    full = new double[large ? 0 : n * n];
    reduced = new double[f * f];
    carried = new double[f];
    lu = new DenseLu(f);
  }

  @Override
  int factor(double hGamma) {
    iteration.form(hGamma);
    TreeSquare a = iteration.matrix();
    directions.formTransformation(jacobian);
    if (full.length == 0) {
      directions.reduceSparse(a, reduced);
    } else {
      a.toDense(full);
      directions.reduceSquare(full, reduced);
    }
    int column = lu.factor(reduced);
    return column == LinearSolver.NONSINGULAR ? REGULAR : velocities.independent[column];
  }

  @Override
  void solve(double[] ofIndependent, double[] change) {
    directions.project(change, carried);
    for (int j = 0; j < carried.length; j++) {
      ofIndependent[j] += carried[j];
    }
    lu.solve(ofIndependent);
    for (int j = 0; j < carried.length; j++) {
      change[velocities.independent[j]] = ofIndependent[j];
    }
    directions.expand(change, 0);
  }
}
