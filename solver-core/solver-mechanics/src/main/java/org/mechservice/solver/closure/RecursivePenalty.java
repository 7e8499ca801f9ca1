package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Penalty equations with the sparsity of the tree. A penalty α is a compliance 1/α of the equations
 * M x + Jᵀ λ = r, J x + c = λ/α, which {@link ArticulatedLoops} factors; the iteration removes the
 * compliance. A dense matrix replaces it if a joint of the open tree moves no inertia, or if
 * velocities of a ball are held and others are not.
 */
final class RecursivePenalty implements PenaltyEquations {
  private static final int REPETITIONS = 10;

  /** Relative residual at which the iteration stops. */
  private static final double ACCURATE = 1e-11;

  /** Reduction of the residual above which the iteration stops. */
  private static final double GAIN = 0.1;

  private final ClosedTree work;
  private final double stiffness;
  private final boolean holds;
  private final ArticulatedLoops factors;
  private final double[] compliance;
  private final double[] gap;
  private final double[] force;
  private final double[] change;
  private final double[] pushed;
  private final double[] multipliers;
  private Optional<DensePenalty> dense = Optional.empty();

  /** Whether the last factors are those of the dense matrix. */
  private boolean byDense;

  RecursivePenalty(ClosedTree work, double stiffness, boolean holds) {
    this.work = work;
    this.stiffness = stiffness;
    this.holds = holds;
    int m = work.loops.count();
    factors =
        new ArticulatedLoops(work.motion, work.loops, IntStream.range(0, m).toArray(), work.rods);
    compliance = new double[m];
    gap = new double[m];
    force = new double[work.nv];
    change = new double[work.nv];
    pushed = new double[m];
    multipliers = new double[m];
  }

  @Override
  public int factor(boolean[] held) {
    formCompliance();
    if (areWholeJoints(held)) {
      int singular = factors.factor(compliance, held);
      byDense = singular >= 0;
      if (!byDense) {
        return singular;
      }
    }
    byDense = true;
    if (dense.isEmpty()) {
      dense = Optional.of(new DensePenalty(work, stiffness, holds));
    }
    return dense.get().factor(held);
  }

  /** Returns whether velocities of balls are held all three or not at all. */
  boolean areWholeJoints(boolean[] held) {
    for (int k = 1; k < held.length; k++) {
      boolean ofOneJoint = work.tree.linkOfVelocity[k] == work.tree.linkOfVelocity[k - 1];
      if (ofOneJoint && held[k] != held[k - 1]) {
        return false;
      }
    }
    return true;
  }

  /** Sets 1/α of a row of unit length; longer rows get more ({@link AugmentedEquations}). */
  private void formCompliance() {
    double[] units = work.units.velocities;
    SparseMatrix jacobian = work.loops.jacobian;
    double largest = stiffness * factors.largestInertia(units);
    for (int row = 0; row < compliance.length; row++) {
      double size = work.loops.size(row);
      double square = 0;
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        double part = jacobian.column[e] < units.length ? units[jacobian.column[e]] : 0;
        part *= jacobian.value[e] / size;
        square += part * part;
      }
      compliance[row] = size * size * Math.max(1, square) / largest;
    }
  }

  @Override
  public void solve(double[] right, double[] offset, double[] x, int at) {
    if (byDense) {
      dense.orElseThrow().solve(right, offset, x, at);
      return;
    }
    Arrays.fill(x, at, at + force.length, 0);
    Arrays.fill(multipliers, 0);
    System.arraycopy(right, 0, force, 0, force.length);
    double open = Double.POSITIVE_INFINITY;
    double left = formGap(offset, x, at);
    for (int i = 0; i < REPETITIONS; i++) {
      factors.solve(force, gap, change, 0, pushed);
      Arrays.fill(force, 0);
      for (int j = 0; j < change.length; j++) {
        x[at + j] += change[j];
      }
      for (int row = 0; row < pushed.length; row++) {
        multipliers[row] += pushed[row] * work.loops.size(row);
      }
      left = formGap(offset, x, at);
      if (i > 0 && (!(left > ACCURATE) || !(left < GAIN * open))) {
        return;
      }
      open = left;
    }
  }

  /** Forms J x + c; returns its largest element relative to the size of its terms. */
  private double formGap(double[] offset, double[] x, int at) {
    double scale = 0;
    double largest = 0;
    SparseMatrix jacobian = work.loops.jacobian;
    for (int row = 0; row < gap.length; row++) {
      double size = work.loops.size(row);
      double moved = 0;
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        if (jacobian.column[e] < force.length) {
          moved += jacobian.value[e] * x[at + jacobian.column[e]];
        }
      }
      gap[row] = offset[row] * size + moved;
      scale = Math.max(scale, Math.max(Math.abs(offset[row]), Math.abs(moved / size)));
      largest = Math.max(largest, Math.abs(gap[row] / size));
    }
    return scale > 0 ? largest / scale : 0;
  }

  @Override
  public double[] multipliers() {
    return byDense ? dense.orElseThrow().multipliers() : multipliers;
  }
}
