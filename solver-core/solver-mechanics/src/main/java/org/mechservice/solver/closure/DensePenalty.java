package org.mechservice.solver.closure;

import org.mechservice.solver.linear.SparseMatrix;

/** Penalty equations with M + α JᵀJ as a dense matrix, which is fast for small mechanisms. */
final class DensePenalty implements PenaltyEquations {
  private final ClosedTree work;
  private final double stiffness;
  private final DenseAugmentedEquations equations;
  private final SparseMatrix rows;
  private final double[] offset;

  /**
   * @param stiffness penalty over the largest inertia
   * @param holds whether velocities may be held fixed, each by an additional equation
   */
  DensePenalty(ClosedTree work, double stiffness, boolean holds) {
    this.work = work;
    this.stiffness = stiffness;
    rows = work.loops.stateRows(work.nv, holds);
    equations = DenseAugmentedEquations.symmetric(rows, work.units.velocities);
    offset = new double[rows.rows()];
  }

  @Override
  public int factor(boolean[] held) {
    work.formMass();
    work.loops.scaledRows(rows);
    for (int k = 0; k < held.length; k++) {
      int place = rows.start[work.loops.count() + k];
      rows.value[place] = held[k] ? 1 / work.units.velocities[k] : 0;
    }
    return equations.factor(work.mass(), stiffness * largestInertia());
  }

  /**
   * Returns the largest diagonal element of M, with displacements in lengths of the mechanism,
   * kg·m².
   */
  private double largestInertia() {
    double largest = 0;
    for (int j = 0; j < work.nv; j++) {
      double unit = work.units.velocities[j];
      largest = Math.max(largest, work.mass()[j * work.nv + j] * unit * unit);
    }
    return largest;
  }

  @Override
  public void solve(double[] right, double[] ofLoops, double[] x, int at) {
    System.arraycopy(ofLoops, 0, offset, 0, work.loops.count());
    equations.solve(right, offset, x, at);
  }

  @Override
  public double[] multipliers() {
    return equations.multipliers;
  }
}
