package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;
import java.util.BitSet;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.StateCoordinates;

/**
 * Derivatives of a residual by forward differences along the tangent, for formulations without
 * analytic derivatives: M comes from composite inertias, the other two derivatives from
 * differences. Velocities that move no common force share an evaluation (Curtis, Powell and Reid
 * 1974), so that a row of loops takes as many evaluations as a few of them. Workspace of one
 * thread.
 */
public final class ResidualDifferences {
  /** Relative step of a difference quotient: half the digits. */
  private static final double PART = 0x1p-26;

  private final ResidualJacobian jacobian;
  private final StateCoordinates coordinates;

  /** Forces that each velocity moves: its own and those that the pattern couples with it. */
  private final int[][] rows;

  /** Velocities of each evaluation. */
  private final int[][] groups;

  /** Change of each velocity or coordinate in the current evaluation. */
  private final double[] change;

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
    rows = rows(pattern);
    groups = groups(rows);
    change = new double[coordinates.velocityCount()];
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
    for (int g = 0; valid && g < groups.length; g++) {
      int[] group = groups[g];
      for (int j : group) {
        moved[nq + j] += PART * Math.max(unit[j], Math.abs(y[nq + j]));
        change[j] = moved[nq + j] - y[nq + j];
      }
      valid = forces.at(moved, force);
      add(jacobian.byVelocity(), group);
      for (int j : group) {
        moved[nq + j] = y[nq + j];
        direction[j] = unit[j];
        change[j] = PART * unit[j];
      }
      coordinates.move(moved, 0, direction, 0, PART);
      valid &= forces.at(moved, force);
      add(jacobian.byPosition(), group);
      for (int j : group) {
        direction[j] = 0;
      }
      System.arraycopy(y, 0, moved, 0, nq);
    }
    return valid && jacobian.isFinite();
  }

  private void add(TreeSquare derivative, int[] group) {
    for (int column : group) {
      for (int row : rows[column]) {
        derivative.add(row, column, (force[row] - base[row]) / change[column]);
      }
    }
  }

  private static int[][] rows(TreePattern pattern) {
    BitSet[] coupled = new BitSet[pattern.size];
    Arrays.setAll(coupled, velocity -> new BitSet(pattern.size));
    for (int place = 0; place < pattern.size; place++) {
      int velocity = pattern.velocityAt[place];
      coupled[velocity].set(velocity);
      for (int e = pattern.rowStart[place]; e < pattern.rowStart[place + 1]; e++) {
        int other = pattern.velocityAt[pattern.column[e]];
        coupled[velocity].set(other);
        coupled[other].set(velocity);
      }
    }
    return Arrays.stream(coupled).map(set -> set.stream().toArray()).toArray(int[][]::new);
  }

  /** Gives each velocity to the first group that moves none of its forces yet. */
  private static int[][] groups(int[][] rows) {
    BitSet[] groupsOfForce = new BitSet[rows.length];
    Arrays.setAll(groupsOfForce, force -> new BitSet());
    BitSet[] groups = new BitSet[rows.length];
    Arrays.setAll(groups, group -> new BitSet());
    BitSet taken = new BitSet();
    for (int velocity = 0; velocity < rows.length; velocity++) {
      taken.clear();
      for (int force : rows[velocity]) {
        taken.or(groupsOfForce[force]);
      }
      int group = taken.nextClearBit(0);
      groups[group].set(velocity);
      for (int force : rows[velocity]) {
        groupsOfForce[force].set(group);
      }
    }
    return Arrays.stream(groups)
        .filter(group -> !group.isEmpty())
        .map(group -> group.stream().toArray())
        .toArray(int[][]::new);
  }
}
