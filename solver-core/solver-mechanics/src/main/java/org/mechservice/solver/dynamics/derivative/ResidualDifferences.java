package org.mechservice.solver.dynamics.derivative;

import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.StateCoordinates;

/**
 * Derivatives of a residual by forward differences along the tangent, for formulations without
 * analytic derivatives: M comes from composite inertias, the other two derivatives from one
 * evaluation per velocity each. Workspace of one thread.
 */
public final class ResidualDifferences {
  /** Relative step of a difference quotient: half the digits. */
  private static final double PART = 0x1p-26;

  private final ResidualJacobian jacobian;
  private final StateCoordinates coordinates;
  private final TreePattern pattern;
  private double[] moved;
  private final double[] direction;
  private final double[] base;
  private final double[] force;

  /** The equations of motion at a state, for accelerations that do not change. */
  @FunctionalInterface
  public interface Forces {
    /**
     * Writes M v' + b − τ.
     *
     * @param y unknowns, which begin with [q; v]; not modified
     * @param force one number per velocity of the state, at least; overwritten
     * @return false if there are none at this state
     */
    boolean at(double[] y, double[] force);
  }

  /**
   * @param pattern sparsity pattern of the derivatives
   * @param forceCount length of the array that {@link Forces} writes
   */
  public ResidualDifferences(
      ResidualJacobian jacobian,
      StateCoordinates coordinates,
      TreePattern pattern,
      int forceCount) {
    this.jacobian = jacobian;
    this.coordinates = coordinates;
    this.pattern = pattern;
    moved = new double[0];
    direction = new double[coordinates.velocityCount()];
    base = new double[forceCount];
    force = new double[forceCount];
  }

  /**
   * Evaluates the derivatives; the motion has been swept at the state.
   *
   * @param y unknowns, which begin with [q; v]; not modified
   * @param unit size of each velocity's coordinate, rad or m
   * @return false if a difference has no value
   */
  public boolean evaluate(double[] y, double[] unit, Forces forces) {
    jacobian.evaluateMass();
    int nq = coordinates.positionCount();
    if (moved.length != y.length) {
      moved = new double[y.length];
    }
    System.arraycopy(y, 0, moved, 0, moved.length);
    boolean valid = forces.at(moved, base);
    for (int j = 0; valid && j < direction.length; j++) {
      double step = PART * Math.max(unit[j], Math.abs(y[nq + j]));
      moved[nq + j] = y[nq + j] + step;
      valid = forces.at(moved, force);
      add(jacobian.byVelocity(), j, moved[nq + j] - y[nq + j]);
      moved[nq + j] = y[nq + j];
      direction[j] = 1;
      double way = PART * unit[j];
      coordinates.move(moved, 0, direction, 0, way);
      valid &= forces.at(moved, force);
      add(jacobian.byPosition(), j, way);
      direction[j] = 0;
      System.arraycopy(y, 0, moved, 0, nq);
    }
    return valid && jacobian.isFinite();
  }

  private void add(TreeSquare derivative, int column, double step) {
    int c = pattern.placeOf[column];
    for (int row = 0; row < direction.length; row++) {
      int r = pattern.placeOf[row];
      if (r == c || pattern.find(Math.max(r, c), Math.min(r, c)) >= 0) {
        derivative.add(row, column, (force[row] - base[row]) / step);
      }
    }
  }
}
