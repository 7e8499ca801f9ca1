package org.mechservice.solver.closure.model;

import java.util.Optional;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.ArticulatedLoops;
import org.mechservice.solver.closure.ClosedTree;

/**
 * The accelerations of a large mechanism, M v' + b − τ + Jᵀ λ = 0 and J v' + γ = 0, by {@link
 * ArticulatedLoops}, for the equations that a {@link Partition} keeps. The kept equations change
 * only when other equations become redundant. Workspace of one thread.
 */
final class RecursiveAccelerations {
  /** Outcome of a solution. */
  enum Solved {
    /** The accelerations have been found. */
    REGULAR,
    /** The kept loop equations are dependent at this state. */
    LOCKED,
    /** The open tree has a joint that moves no inertia. */
    WITHOUT_INERTIA
  }

  private final ClosedTree work;
  private final Partition partition;
  private Optional<ArticulatedLoops> factors = Optional.empty();
  private final double[] force;
  private final double[] lambda;

  RecursiveAccelerations(ClosedTree work, Partition partition) {
    this.work = work;
    this.partition = partition;
    force = new double[work.nv];
    lambda = new double[work.loops.count()];
  }

  /**
   * Solves at the placed state, after the bias was formed.
   *
   * @param a accelerations from {@code at}; overwritten
   */
  Solved solve(double[] a, int at) {
    if (factors.isEmpty() || !factors.get().areOf(partition.kept)) {
      factors =
          Optional.of(new ArticulatedLoops(work.motion, work.loops, partition.kept, work.rods));
    }
    int factored = factors.get().factor();
    if (factored != ExplicitModel.REGULAR) {
      return factored >= 0 ? Solved.WITHOUT_INERTIA : Solved.LOCKED;
    }
    for (int j = 0; j < force.length; j++) {
      force[j] = -work.bias()[j];
    }
    factors.get().solve(force, work.loops.acceleration, a, at, lambda);
    return Solved.REGULAR;
  }
}
