package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.multiply;
import static org.mechservice.solver.spatial.Blocks.rotationAbout;

import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.SinCos;

/**
 * Computes the pose of each link relative to its parent, and the motion subspace. Columns that are
 * constant in link axes are written once.
 */
final class LinkPlacement {
  private final TreeGeometry tree;
  private final double[] rotation;
  private final double[] position;
  private final double[] subspace;
  private final double[] turn = new double[9];
  private final double[] sinCos = new double[2];

  /** Writes to the arrays of a {@link TreeMotion}. */
  LinkPlacement(TreeGeometry tree, double[] rotation, double[] position, double[] subspace) {
    this.tree = tree;
    this.rotation = rotation;
    this.position = position;
    this.subspace = subspace;
    for (int link = 0; link < tree.linkCount; link++) {
      startLink(link);
    }
  }

  private void startLink(int link) {
    int at = 6 * tree.velocityAt[link];
    System.arraycopy(tree.offset, 3 * link, position, 3 * link, 3);
    System.arraycopy(tree.zeroRotation, 9 * link, rotation, 9 * link, 9);
    switch (tree.kind[link]) {
      case TURN -> System.arraycopy(tree.axisInLink, 3 * link, subspace, at, 3);
      case SLIDE -> System.arraycopy(tree.axisInLink, 3 * link, subspace, at + 3, 3);
      case SCREW -> {
        for (int i = 0; i < 3; i++) {
          subspace[at + i] = tree.axisInLink[3 * link + i];
          subspace[at + 3 + i] = tree.pitch[link] * tree.axisInLink[3 * link + i];
        }
      }
      case BALL -> {
        // seen from body 2, body 1 turns by −ω in its own axes
        for (int k = 0; k < 3; k++) {
          subspace[at + 6 * k + k] = -1;
        }
      }
      case FIXED -> {
        // no column
      }
    }
  }

  /**
   * Writes rotation and position of a link, and the columns of its subspace that are not constant.
   */
  void place(int link, double[] q) {
    switch (tree.kind[link]) {
      case TURN -> turn(link, q[tree.positionAt[link]]);
      case SLIDE -> slide(link, q[tree.positionAt[link]]);
      case SCREW -> {
        turn(link, q[tree.positionAt[link]]);
        slide(link, tree.pitch[link] * q[tree.positionAt[link]]);
      }
      case BALL -> ball(link, q);
      case FIXED -> {
        // a fixed link keeps its pose
      }
    }
  }

  /** R = Rot(axis, q) A0. */
  private void turn(int link, double q) {
    SinCos.sinCos(q, sinCos, 0);
    if (tree.parallelAtZero[link]) {
      rotationAbout(tree.axisInParent, 3 * link, sinCos[0], sinCos[1], rotation, 9 * link);
    } else {
      rotationAbout(tree.axisInParent, 3 * link, sinCos[0], sinCos[1], turn, 0);
      multiply(turn, 0, tree.zeroRotation, 9 * link, rotation, 9 * link);
    }
  }

  /** p = offset + q axis. */
  private void slide(int link, double q) {
    for (int i = 3 * link; i < 3 * link + 3; i++) {
      position[i] = tree.offset[i] + q * tree.axisInParent[i];
    }
  }

  /**
   * R = R(e/|e|), and the columns Rᵀ e_k of the angular velocity given in parent axes; or R = R(e/|
   * e|)ᵀ, whose columns −e_k are constant in link axes.
   */
  private void ball(int link, double[] q) {
    if (!tree.inverse[link]) {
      EulerParameters.rotation(q, tree.positionAt[link], rotation, 9 * link);
      int at = 6 * tree.velocityAt[link];
      for (int k = 0; k < 3; k++) {
        System.arraycopy(rotation, 9 * link + 3 * k, subspace, at + 6 * k, 3);
      }
      return;
    }
    EulerParameters.rotation(q, tree.positionAt[link], turn, 0);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        rotation[9 * link + 3 * i + j] = turn[3 * j + i];
      }
    }
  }
}
