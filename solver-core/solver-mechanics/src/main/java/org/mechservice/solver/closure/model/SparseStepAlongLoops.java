package org.mechservice.solver.closure.model;

import java.util.function.DoubleToIntFunction;
import org.mechservice.solver.closure.AugmentedEquations;
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

  /** J with scaled rows at the linearisation. */
  private final SparseMatrix rows;

  private final AugmentedEquations equations;

  /** Factors {@link #equations} for hγ; a negative number, or the velocity without a pivot. */
  private final DoubleToIntFunction factors;

  private final double[] right;
  private final double[] none;

  /**
   * @param velocities partition of the velocities
   * @param rows of the equations, overwritten with J at each linearisation
   */
  SparseStepAlongLoops(
      Partition velocities,
      LoopEquations loops,
      SparseMatrix rows,
      AugmentedEquations equations,
      DoubleToIntFunction factors) {
    this.velocities = velocities;
    this.loops = loops;
    this.rows = rows;
    this.equations = equations;
    this.factors = factors;
    right = new double[velocities.n];
    none = new double[loops.count()];
  }

  /**
   * Returns a step with A in the sparsity of the tree.
   *
   * @param velocities partition of the velocities
   * @param units of the velocities, 1/s
   * @param pattern of A
   */
  static SparseStepAlongLoops of(
      Partition velocities,
      LoopEquations loops,
      double[] units,
      TreeIteration iteration,
      TreePattern pattern) {
    SparseMatrix rows = loops.stateRows(velocities.n, false);
    SparseAugmentedEquations equations = new SparseAugmentedEquations(rows, units, pattern);
    return new SparseStepAlongLoops(
        velocities,
        loops,
        rows,
        equations,
        hGamma -> {
          iteration.form(hGamma);
          TreeSquare a = iteration.matrix();
          double largest = 0;
          for (int j = 0; j < units.length; j++) {
            largest = Math.max(largest, Math.abs(a.get(j, j)) * units[j] * units[j]);
          }
          return equations.factor(a, PenaltySettings.DEFAULT.stiffness() * largest);
        });
  }

  @Override
  void linearise() {
    loops.scaledRows(rows);
    equations.linearise();
  }

  @Override
  int factor(double hGamma) {
    int singular = factors.applyAsInt(hGamma);
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
