package org.mechservice.solver.closure;

import org.mechservice.solver.linear.Cholesky;

/** Penalty equations with M + α JᵀJ as a dense matrix, which is fast for small mechanisms. */
final class DensePenalty implements PenaltyEquations {
  private final ClosedTree work;
  private final double stiffness;
  private final AugmentedEquations equations;
  private final double[] rows;
  private final double[] offset;

  /**
   * @param stiffness penalty over the largest inertia
   * @param holds whether velocities may be held fixed, each by an additional equation
   */
  DensePenalty(ClosedTree work, double stiffness, boolean holds) {
    this.work = work;
    this.stiffness = stiffness;
    int count = work.loops.count() + (holds ? work.nv : 0);
    equations =
        new AugmentedEquations(
            count, work.units.velocities, AugmentedEquations.Factors.of(new Cholesky(work.nv)));
    rows = new double[count * work.nv];
    offset = new double[count];
  }

  @Override
  public int factor(boolean[] held) {
    work.formMass();
    work.loops.scaledRows(rows, work.nv);
    for (int k = 0; k < held.length; k++) {
      rows[(work.loops.count() + k) * work.nv + k] = held[k] ? 1 / work.units.velocities[k] : 0;
    }
    return equations.factor(work.mass(), rows, stiffness * largestInertia());
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
