package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;

/**
 * Positions, velocities and accelerations of points on the links, in world axes, from the last
 * sweeps of a {@link TreeMotion}. Workspace of the thread of that motion; nothing allocates.
 */
public final class PointMotion {
  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final double[] carried = new double[3];

  /** Reads the arrays of a motion. */
  PointMotion(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
  }

  /**
   * Writes the position of a point in the world.
   *
   * @param link the point's link, or {@link TreeGeometry#ROOT}
   * @param r from the link's reference point (the root's origin), in link (root) axes, m
   * @param out from the world's origin, world axes, m; overwritten
   */
  public void position(int link, double[] r, int rAt, double[] out, int at) {
    boolean onRoot = link == TreeGeometry.ROOT;
    motion.toWorld(link, r, rAt, out, at);
    for (int i = 0; i < 3; i++) {
      out[at + i] += onRoot ? tree.rootPosition[i] : motion.worldPosition[3 * link + i];
    }
  }

  /**
   * Writes the velocity of a point, world axes, m/s; arguments as for {@link #position}.
   *
   * @param out overwritten
   */
  public void velocity(int link, double[] r, int rAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      setZero(out, at);
      return;
    }
    // u + ω × r
    System.arraycopy(motion.linearVelocity, 3 * link, carried, 0, 3);
    addCross(motion.angularVelocity, 3 * link, r, rAt, carried, 0);
    apply(motion.worldRotation, 9 * link, carried, 0, out, at);
  }

  /**
   * Writes the acceleration of a point after {@link TreeMotion#accelerationSweep(double[])}, world
   * axes, m/s²; arguments as for {@link #position}.
   *
   * @param out overwritten
   */
  public void acceleration(int link, double[] r, int rAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      setZero(out, at);
      return;
    }
    // u' + α × r + ω × (u + ω × r)
    System.arraycopy(motion.linearVelocity, 3 * link, carried, 0, 3);
    addCross(motion.angularVelocity, 3 * link, r, rAt, carried, 0);
    double x = carried[0];
    double y = carried[1];
    double z = carried[2];
    System.arraycopy(motion.linearAcceleration, 3 * link, carried, 0, 3);
    addCross(motion.angularAcceleration, 3 * link, r, rAt, carried, 0);
    double wx = motion.angularVelocity[3 * link];
    double wy = motion.angularVelocity[3 * link + 1];
    double wz = motion.angularVelocity[3 * link + 2];
    carried[0] += wy * z - wz * y;
    carried[1] += wz * x - wx * z;
    carried[2] += wx * y - wy * x;
    apply(motion.worldRotation, 9 * link, carried, 0, out, at);
  }

  /**
   * Writes the vector from one point to another, summed along the tree from their nearest common
   * ancestor, so that it keeps its digits far from the world's origin.
   *
   * @param ancestor {@link TreeGeometry#commonAncestor} of the two links
   * @param out second point minus first, world axes, m; overwritten
   */
  public void difference(
      int ancestor,
      int first,
      double[] r1,
      int r1At,
      int second,
      double[] r2,
      int r2At,
      double[] out,
      int at) {
    fromAncestor(ancestor, first, r1, r1At);
    double x = carried[0];
    double y = carried[1];
    double z = carried[2];
    fromAncestor(ancestor, second, r2, r2At);
    carried[0] -= x;
    carried[1] -= y;
    carried[2] -= z;
    motion.toWorld(ancestor, carried, 0, out, at);
  }

  /**
   * Writes the position of a point to {@code carried}, from the ancestor's reference point in its
   * axes.
   */
  private void fromAncestor(int ancestor, int link, double[] r, int rAt) {
    System.arraycopy(r, rAt, carried, 0, 3);
    for (int i = link; i != ancestor; i = tree.parent[i]) {
      double x = carried[0];
      double y = carried[1];
      double z = carried[2];
      for (int k = 0; k < 3; k++) {
        int row = 9 * i + 3 * k;
        carried[k] =
            motion.position[3 * i + k]
                + (motion.rotation[row] * x
                    + motion.rotation[row + 1] * y
                    + motion.rotation[row + 2] * z);
      }
    }
  }

  private static void setZero(double[] out, int at) {
    out[at] = 0;
    out[at + 1] = 0;
    out[at + 2] = 0;
  }
}
