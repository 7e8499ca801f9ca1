package org.mechservice.solver.closure.model;

import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.SparseAugmentedEquations;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * A step along loops as A Δv + Jᵀ λ = r, J Δv = 0, without R: neither R nor Rᵀ A R is sparse where
 * a mechanism has many degrees of freedom, the equations with λ are.
 */
final class SparseStepAlongLoops extends StepAlongLoops {
  private final Partition velocities;
  private final LoopEquations loops;
  private final TreeIteration iteration;

  /** J with scaled rows at the linearisation. */
  private final SparseMatrix rows;

  private final SparseAugmentedEquations equations;
  private final double[] units;
  private final double[] right;
  private final double[] none;

  /**
   * @param velocities partition of the velocities
   * @param units of the velocities, 1/s
   * @param pattern of A
   */
  SparseStepAlongLoops(
      Partition velocities,
      LoopEquations loops,
      double[] units,
      TreeIteration iteration,
      TreePattern pattern) {
    this.iteration = iteration;
    this.velocities = velocities;
    this.loops = loops;
    this.units = units;
    rows = loops.stateRows(velocities.n, false);
    equations = new SparseAugmentedEquations(rows, units, pattern);
    right = new double[velocities.n];
    none = new double[loops.count()];
  }

  @Override
  void linearise() {
    loops.scaledRows(rows);
  }

  @Override
  int factor(double hGamma) {
    iteration.form(hGamma);
    TreeSquare a = iteration.matrix();
    double largest = 0;
    for (int j = 0; j < units.length; j++) {
      largest = Math.max(largest, Math.abs(a.get(j, j)) * units[j] * units[j]);
    }
    int singular = equations.factor(a, PenaltySettings.DEFAULT.stiffness() * largest);
    return singular < 0 ? REGULAR : singular;
  }

  @Override
  void solve(double[] ofIndependent, double[] change) {
    System.arraycopy(change, 0, right, 0, right.length);
    for (int j = 0; j < ofIndependent.length; j++) {
      right[velocities.independent[j]] += ofIndependent[j];
    }
    equations.solve(right, none, change, 0);
  }
}
