package org.mechservice.solver.closure.model;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * A step along few loops of long chains: A Δv + Jᵀ λ = r, J Δv = 0 with A eliminated from link to
 * link, so that J A⁻¹ Jᵀ λ = J A⁻¹ r. With m equations it takes O(n m + m³) operations.
 */
final class ArticulatedStepAlongLoops extends StepAlongLoops {
  /** Solutions of the loops' equations: the second removes what rounding left of the first. */
  private static final int PASSES = 2;

  private final Partition velocities;
  private final LoopEquations loops;
  private final ArticulatedIteration iteration;

  /** J with scaled rows at the linearisation. */
  private final SparseMatrix rows;

  /** A⁻¹ Jᵀ, column by column. */
  private final double[][] pushed;

  private final double[] compliance;
  private final double[] multipliers;
  private final DenseLu lu;

  /**
   * @param velocities partition of the velocities
   */
  ArticulatedStepAlongLoops(
      Partition velocities, LoopEquations loops, ArticulatedIteration iteration) {
    this.velocities = velocities;
    this.loops = loops;
    this.iteration = iteration;
    rows = loops.stateRows(velocities.n, false);
    int m = loops.count();
    pushed = new double[m][velocities.n];
    compliance = new double[m * m];
    multipliers = new double[m];
    lu = new DenseLu(m);
  }

  @Override
  void linearise() {
    loops.scaledRows(rows);
  }

  @Override
  int factor(double hGamma) {
    if (!iteration.factor(hGamma)) {
      return iteration.singularVelocity();
    }
    int m = pushed.length;
    for (int row = 0; row < m; row++) {
      double[] push = pushed[row];
      Arrays.fill(push, 0);
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        push[rows.column[e]] = rows.value[e];
      }
      iteration.solveReduced(push);
      for (int other = 0; other < m; other++) {
        compliance[other * m + row] = rows.product(other, push, 0);
      }
    }
    int column = lu.factor(compliance);
    return column == LinearSolver.NONSINGULAR ? REGULAR : velocities.dependent[column];
  }

  @Override
  void solve(double[] ofIndependent, double[] change) {
    for (int j = 0; j < ofIndependent.length; j++) {
      change[velocities.independent[j]] += ofIndependent[j];
    }
    iteration.solveReduced(change);
    for (int pass = 0; pass < PASSES; pass++) {
      for (int row = 0; row < pushed.length; row++) {
        multipliers[row] = rows.product(row, change, 0);
      }
      lu.solve(multipliers);
      for (int row = 0; row < pushed.length; row++) {
        double[] push = pushed[row];
        for (int j = 0; j < change.length; j++) {
          change[j] -= multipliers[row] * push[j];
        }
      }
    }
  }
}
