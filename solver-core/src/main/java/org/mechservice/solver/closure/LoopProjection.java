package org.mechservice.solver.closure;

import org.mechservice.solver.linear.Cholesky;

/**
 * Moves positions and velocities onto the loops by the least change in the metric of the mass
 * matrix (NUMERICS §3): what an impulse along the constraints does to velocities. Workspace of one
 * thread.
 */
final class LoopProjection {
  /** Residual over its size, or rate over the speed, below which a state is left alone. */
  private static final double CLOSED = 1e-13;

  /** Residual that will do if another repetition does not reduce it. */
  private static final double NEARLY = 1e-11;

  private static final int ITERATIONS = 12;

  /** Beyond half a radian the positions found may be those of another assembly. */
  private static final double TOO_FAR = 0.5;

  /** Velocities changed by this part of all are those of another branch. */
  private static final double OTHER_BRANCH = 0.25;

  private final ClosedTree work;
  private final PenaltySettings settings;
  private final AugmentedEquations equations;
  private final double[] rows;
  private final double[] none;
  private final double[] offset;
  private final double[] change;

  LoopProjection(ClosedTree work, PenaltySettings settings) {
    this.work = work;
    this.settings = settings;
    equations =
        new AugmentedEquations(
            work.loops.count(), work.nv, AugmentedEquations.Factors.of(new Cholesky(work.nv)));
    rows = new double[work.loops.count() * work.nv];
    none = new double[work.nv];
    offset = new double[work.loops.count()];
    change = new double[work.nv];
  }

  /** Returns the equations of the places last factored, for accelerations too. */
  AugmentedEquations equations() {
    return equations;
  }

  /** Forms M and factors where the work is placed; returns a negative number or the velocity. */
  int factor() {
    work.formMass();
    work.loops.scaledRows(rows, work.nv);
    return equations.factor(work.mass, rows, settings.stiffness() * largestInertia());
  }

  /** Returns the largest element on the diagonal of M, displacements in lengths, kg·m². */
  private double largestInertia() {
    double largest = 0;
    for (int j = 0; j < work.nv; j++) {
      double unit = work.units.velocities[j];
      largest = Math.max(largest, work.mass[j * work.nv + j] * unit * unit);
    }
    return largest;
  }

  /** Moves positions, then velocities; returns whether both obey the loops. */
  boolean project(double t, double[] y) {
    return projectPositions(t, y) && projectVelocities(t, y, OTHER_BRANCH);
  }

  private boolean projectPositions(double t, double[] y) {
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i < ITERATIONS; i++) {
      work.place(t, y);
      double residual = work.loops.largestResidual();
      if (residual <= CLOSED || (residual <= NEARLY && residual > 0.5 * before)) {
        return true;
      }
      if (!(residual < before) || factor() >= 0) {
        return false;
      }
      before = residual;
      solve(work.loops.value);
      if (!(largestChange() <= TOO_FAR)) {
        return false;
      }
      work.coordinates.move(y, 0, change, 0, 1);
    }
    return false;
  }

  /**
   * Changes velocities as an impulse along the constraints does.
   *
   * @param allowed part of all velocities by which they may change
   * @return whether they obey the loops
   */
  boolean projectVelocities(double t, double[] y, double allowed) {
    work.place(t, y);
    double speed = work.units.speed(y, work.nq);
    if (!(rate() > CLOSED * speed)) {
      return Double.isFinite(speed);
    }
    if (factor() >= 0) {
      return false;
    }
    solve(work.loops.rate);
    if (!(largestChange() <= allowed * speed)) {
      return false;
    }
    for (int j = 0; j < work.nv; j++) {
      y[work.nq + j] += change[j];
    }
    return true;
  }

  /** Returns the largest rate over its size, 1/s, where the work is placed. */
  double rate() {
    int worst = work.loops.worst(work.loops.rate);
    return worst < 0 ? 0 : Math.abs(work.loops.rate[worst]) / work.loops.size(worst);
  }

  private void solve(double[] residual) {
    for (int row = 0; row < offset.length; row++) {
      offset[row] = residual[row] / work.loops.size(row);
    }
    equations.solve(none, offset, change, 0);
  }

  private double largestChange() {
    double largest = 0;
    for (int j = 0; j < work.nv; j++) {
      double part = Math.abs(change[j]) / work.units.velocities[j];
      largest = part > largest || Double.isNaN(part) ? part : largest;
    }
    return largest;
  }
}
