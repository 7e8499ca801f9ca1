package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;

/**
 * Rows of J in motions of links: an equation of a loop is J v = Σ w_i · V_i + Σ τ_k v_k with the
 * wrenches w on the links and the joint forces τ that its multiplier exerts, where a row by joint
 * coordinates has an element for each joint on the way. Workspace of one thread.
 */
public final class LoopWrenches {
  /** No rows. */
  public static final LoopWrenches NONE = new LoopWrenches(new int[0][], new int[0][]);

  /** Links of each row, and where the wrenches of the row begin. */
  final int[][] links;

  final int[] wrenchAt;

  /** Velocities of the state of each row, and where its forces begin. */
  final int[][] velocities;

  final int[] forceAt;

  /** w, [moment; force] in link axes, 6 for each link of a row; τ, one for each velocity. */
  final double[] wrench;

  final double[] force;

  /**
   * Makes rows of zeros.
   *
   * @param links on which the multiplier of each row exerts wrenches; not modified
   * @param velocities of the state on which it exerts forces; not modified
   */
  public LoopWrenches(int[][] links, int[][] velocities) {
    this.links = links.clone();
    this.velocities = velocities.clone();
    wrenchAt = new int[links.length + 1];
    forceAt = new int[links.length + 1];
    for (int row = 0; row < links.length; row++) {
      wrenchAt[row + 1] = wrenchAt[row] + 6 * links[row].length;
      forceAt[row + 1] = forceAt[row] + velocities[row].length;
    }
    wrench = new double[wrenchAt[links.length]];
    force = new double[forceAt[links.length]];
  }

  /** Returns the number of rows. */
  public int count() {
    return links.length;
  }

  /** Sets a row to zero. */
  public void clear(int row) {
    Arrays.fill(wrench, wrenchAt[row], wrenchAt[row + 1], 0);
    Arrays.fill(force, forceAt[row], forceAt[row + 1], 0);
  }

  /**
   * Takes a row, and sets what it was taken from to zero.
   *
   * @param wrenches 6 numbers for each link of the tree; those of the row are overwritten
   * @param forces one number for each velocity; those of the row are overwritten
   */
  public void take(int row, double[] wrenches, double[] forces) {
    int at = wrenchAt[row];
    for (int link : links[row]) {
      System.arraycopy(wrenches, 6 * link, wrench, at, 6);
      Arrays.fill(wrenches, 6 * link, 6 * link + 6, 0);
      at += 6;
    }
    at = forceAt[row];
    for (int velocity : velocities[row]) {
      force[at++] = forces[velocity];
      forces[velocity] = 0;
    }
  }
}
