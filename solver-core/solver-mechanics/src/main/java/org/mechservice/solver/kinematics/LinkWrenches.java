package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;

/**
 * Wrenches on the links: [moment; force] in link axes at the reference point, N·m and N. Workspace
 * of the thread of its {@link TreeMotion}; nothing allocates.
 */
public final class LinkWrenches {
  private final TreeGeometry tree;
  private final double[] rotation;
  private final double[] position;
  private final double[] worldRotation;
  private final double[] subspace;
  private final double[] carried = new double[3];

  /** Reads the arrays of a motion. */
  LinkWrenches(TreeMotion motion) {
    tree = motion.tree();
    rotation = motion.rotation;
    position = motion.position;
    worldRotation = motion.worldRotation;
    subspace = motion.subspace;
  }

  /**
   * Adds a force at a point to the wrench of its link; has no effect on the root.
   *
   * @param link the point's link, or {@link TreeGeometry#ROOT}
   * @param r from the link's reference point, in link axes, m
   * @param force in world axes, N
   * @param wrench [moment; force] in link axes at the reference point, 6 per link, N·m, N; added to
   */
  public void addForceAtPoint(
      int link, double[] r, int rAt, double[] force, int forceAt, double[] wrench) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    applyTransposed(worldRotation, 9 * link, force, forceAt, carried, 0);
    addCross(r, rAt, carried, 0, wrench, 6 * link);
    for (int i = 0; i < 3; i++) {
      wrench[6 * link + 3 + i] += carried[i];
    }
  }

  /**
   * Adds factor · wᵀ J to a row, with J the derivative of the link's velocity by the extended
   * velocities. The row holds the forces of the wrench on all ancestor joints.
   *
   * @param link the link, or {@link TreeGeometry#ROOT} for no effect
   * @param wrench [moment; force] in link axes at its reference point; overwritten
   * @param row one number per extended velocity; added to
   */
  public void addRow(int link, double[] wrench, int wrenchAt, double factor, double[] row) {
    for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end; k++) {
        double sum = 0;
        for (int m = 0; m < 6; m++) {
          sum += wrench[wrenchAt + m] * subspace[6 * k + m];
        }
        row[k] += factor * sum;
      }
      toParent(i, wrench, wrenchAt);
    }
  }

  /**
   * Refers a wrench to the parent of a link: f_p = R f, n_p = R n + p × f_p.
   *
   * @param wrench [moment; force] in link axes; overwritten with that in parent axes
   */
  public void toParent(int link, double[] wrench, int at) {
    apply(rotation, 9 * link, wrench, at + 3, carried, 0);
    double x = wrench[at];
    double y = wrench[at + 1];
    double z = wrench[at + 2];
    System.arraycopy(carried, 0, wrench, at + 3, 3);
    cross(position, 3 * link, carried, 0, wrench, at);
    for (int k = 0; k < 3; k++) {
      int row = 9 * link + 3 * k;
      wrench[at + k] += rotation[row] * x + rotation[row + 1] * y + rotation[row + 2] * z;
    }
  }
}
