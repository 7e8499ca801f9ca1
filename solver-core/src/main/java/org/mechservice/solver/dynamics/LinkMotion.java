package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.multiply;
import static org.mechservice.solver.spatial.Blocks.rotationAbout;

import org.mechservice.solver.spatial.SinCos;

/**
 * Where each link stands relative to its parent, and how fast it moves: the outward sweep that
 * every recursion begins with. Workspace of one thread.
 */
final class LinkMotion {
  private final TreeGeometry tree;

  /** Rotation child axes to parent axes, 9 per link. */
  final double[] rotation;

  /** Reference point from the parent's reference point, in parent axes, m, 3 per link. */
  final double[] position;

  /** Angular velocity in body axes, rad/s, 3 per link. */
  final double[] angularVelocity;

  /** Velocity of the reference point in body axes, m/s, 3 per link. */
  final double[] linearVelocity;

  private final double[] turn = new double[9];
  private final double[] sinCos = new double[2];
  private final double[] carried = new double[3];

  LinkMotion(TreeGeometry tree) {
    this.tree = tree;
    rotation = new double[9 * tree.linkCount];
    position = new double[3 * tree.linkCount];
    angularVelocity = new double[3 * tree.linkCount];
    linearVelocity = new double[3 * tree.linkCount];
  }

  /**
   * Sweeps outwards.
   *
   * @param y positions at 0, rad or m; not modified
   * @param velocityAt where the velocities begin in {@code y}, rad/s or m/s
   */
  void sweep(double[] y, int velocityAt) {
    for (int link = 0; link < tree.linkCount; link++) {
      place(link, y[tree.coordinate[link]]);
      move(link, y[velocityAt + tree.coordinate[link]]);
    }
  }

  /** R = Rot(axis, q) A0, p = offset; or R = A0, p = offset + q axis. */
  private void place(int link, double q) {
    System.arraycopy(tree.offset, 3 * link, position, 3 * link, 3);
    if (tree.slides[link]) {
      System.arraycopy(tree.zeroRotation, 9 * link, rotation, 9 * link, 9);
      for (int i = 3 * link; i < 3 * link + 3; i++) {
        position[i] += q * tree.axisInParent[i];
      }
    } else {
      SinCos.sinCos(q, sinCos, 0);
      rotationAbout(tree.axisInParent, 3 * link, sinCos[0], sinCos[1], turn, 0);
      multiply(turn, 0, tree.zeroRotation, 9 * link, rotation, 9 * link);
    }
  }

  /**
   * ω = Rᵀ ω_p + axis q', u = Rᵀ (u_p + ω_p × p) for a turning joint; u = … + axis q' for a sliding
   * one.
   */
  private void move(int link, double rate) {
    int at = 3 * link;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      for (int i = at; i < at + 3; i++) {
        angularVelocity[i] = 0;
        linearVelocity[i] = 0;
      }
    } else {
      applyTransposed(rotation, 9 * link, angularVelocity, 3 * parent, angularVelocity, at);
      System.arraycopy(linearVelocity, 3 * parent, carried, 0, 3);
      addCross(angularVelocity, 3 * parent, position, at, carried, 0);
      applyTransposed(rotation, 9 * link, carried, 0, linearVelocity, at);
    }
    double[] moved = tree.slides[link] ? linearVelocity : angularVelocity;
    for (int i = at; i < at + 3; i++) {
      moved[i] += rate * tree.axisInChild[i];
    }
  }
}
