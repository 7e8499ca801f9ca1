package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.ArticulatedLoops;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The accelerations of a large mechanism, M v' + b − τ + Jᵀ λ = 0 and J v' + γ = 0, by {@link
 * ArticulatedLoops}, for the equations that a {@link Partition} keeps. The kept equations change
 * only when other equations become redundant. Workspace of one thread.
 *
 * <p>A joint that moves no inertia in the open tree, such as that of a massless coupler, has no
 * pivot before the loops are closed. It gets a small inertia E, and what E changes is removed by
 * iteration with the residuals of the true equations, the proximal method (Rockafellar 1976):
 *
 * <pre>(M + E) Δv' + Jᵀ Δλ = −(M v' + b − τ + Jᵀ λ),   J Δv' = −(J v' + γ)</pre>
 *
 * <p>Its error shrinks by E over the inertia that moves with the joint in the closed mechanism.
 */
final class RecursiveAccelerations {
  /** Outcome of a solution. */
  enum Solved {
    /** The accelerations have been found. */
    REGULAR,
    /** The kept loop equations are dependent at this state. */
    LOCKED,
    /** The open tree has a joint that moves no inertia, and no added inertia helps. */
    WITHOUT_INERTIA
  }

  /** E over the largest inertia that a joint moves: the first choice, and the least. */
  private static final double FIRST_INERTIA = 1e-4;

  private static final double LEAST_INERTIA = 1e-11;

  /** Factor by which E is lowered where the iteration does not converge. */
  private static final double LOWER = 1e-2;

  private static final int REPETITIONS = 12;

  /** Relative change of the accelerations at which the iteration stops. */
  private static final double ACCURATE = 1e-13;

  /** Relative change that is taken if rounding lets it shrink no more. */
  private static final double ACCEPTABLE = 1e-11;

  /** Least gain of a repetition. */
  private static final double GAIN = 0.3;

  private final ClosedTree work;
  private final Partition partition;
  private Optional<ArticulatedLoops> factors = Optional.empty();
  private final double[] force;
  private final double[] lambda;

  /** E as a part of the largest inertia; 0 while all joints move inertia. */
  private double part;

  /** E, and what it is where it is not zero; empty until a pivot lacks. */
  private double[] added = {};

  private double[] least = {};

  /** Residuals of the equations and corrections; empty until a pivot lacks. */
  private double[] residual = {};

  private double[] gap = {};
  private double[] change = {};
  private double[] push = {};

  RecursiveAccelerations(ClosedTree work, Partition partition) {
    this.work = work;
    this.partition = partition;
    force = new double[work.nv];
    lambda = new double[work.loops.count()];
  }

  /**
   * Solves at the placed state, after the bias was formed.
   *
   * @param t time, s
   * @param a accelerations from {@code at}; overwritten
   */
  Solved solve(double t, double[] a, int at) {
    if (factors.isEmpty() || !factors.get().areOf(partition.kept)) {
      makeFactors();
    }
    int factored = part > 0 ? ExplicitModel.REGULAR : factors.get().factor();
    if (part > 0 || factored >= 0) {
      return solveWithAdded(t, a, at);
    }
    if (factored != ExplicitModel.REGULAR) {
      return Solved.LOCKED;
    }
    solve(a, at);
    return Solved.REGULAR;
  }

  private void makeFactors() {
    factors =
        Optional.of(
            part > 0
                ? ArticulatedLoops.withAdded(work.motion, work.loops, partition.kept, work.rods)
                : new ArticulatedLoops(work.motion, work.loops, partition.kept, work.rods));
  }

  private void solve(double[] a, int at) {
    for (int j = 0; j < force.length; j++) {
      force[j] = -work.bias()[j];
    }
    factors.orElseThrow().solve(force, work.loops.acceleration, a, at, lambda);
  }

  /** Lowers E until the iteration converges. */
  private Solved solveWithAdded(double t, double[] a, int at) {
    if (part == 0) {
      part = FIRST_INERTIA;
      added = new double[work.nv];
      least = new double[work.nv];
      residual = new double[work.tree.velocityCount];
      gap = new double[lambda.length];
      change = new double[work.nv];
      push = new double[lambda.length];
      makeFactors();
    }
    ArticulatedLoops tree = factors.orElseThrow();
    double[] units = work.units.velocities;
    double largest = tree.largestInertia(units);
    for (; part >= LEAST_INERTIA; part *= LOWER) {
      for (int k = 0; k < least.length; k++) {
        least[k] = part * largest / (units[k] * units[k]);
      }
      Arrays.fill(added, 0);
      int factored = tree.factor(added, least);
      if (factored != ExplicitModel.REGULAR) {
        return factored >= 0 ? Solved.WITHOUT_INERTIA : Solved.LOCKED;
      }
      solve(a, at);
      if (Arrays.stream(added).allMatch(inertia -> inertia == 0) || removeAdded(t, a, at)) {
        return Solved.REGULAR;
      }
    }
    part = LEAST_INERTIA;
    return Solved.WITHOUT_INERTIA;
  }

  /** Returns whether the accelerations have converged to those without E. */
  private boolean removeAdded(double t, double[] a, int at) {
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i < REPETITIONS; i++) {
      if (!formResiduals(t, a, at)) {
        return false;
      }
      factors.orElseThrow().solve(force, gap, change, 0, push);
      double size = 0;
      double changed = 0;
      for (int k = 0; k < change.length; k++) {
        a[at + k] += change[k];
        size = Math.max(size, Math.abs(a[at + k]) / work.units.velocities[k]);
        changed = Math.max(changed, Math.abs(change[k]) / work.units.velocities[k]);
      }
      for (int row = 0; row < lambda.length; row++) {
        lambda[row] += push[row];
      }
      if (changed <= ACCURATE * size) {
        return true;
      }
      if (!(changed < GAIN * before)) {
        return changed <= ACCEPTABLE * size;
      }
      before = changed;
    }
    return false;
  }

  /** Forms −(M v' + b − τ + Jᵀ λ) and J v' + γ; returns whether all forces have values. */
  private boolean formResiduals(double t, double[] a, int at) {
    if (!work.formResidual(t, a, at, residual)) {
      return false;
    }
    SparseMatrix jacobian = work.loops.jacobian;
    for (int row = 0; row < lambda.length; row++) {
      gap[row] = work.loops.acceleration[row];
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        if (jacobian.column[e] < work.nv) {
          gap[row] += jacobian.value[e] * a[at + jacobian.column[e]];
        }
      }
      if (lambda[row] != 0) {
        jacobian.addRow(row, lambda[row], residual, 0);
      }
    }
    for (int k = 0; k < force.length; k++) {
      force[k] = -residual[k];
    }
    return true;
  }
}
