package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.dot;
import static org.mechservice.solver.spatial.Blocks.multiply;

import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Where the bodies are in the world, how they move, and their energy. Workspace of one thread. */
final class WorldMotion {
  private final TreeGeometry tree;
  private final LinkMotion motion;
  private final double[] rootRotation;
  private final double[] rootPosition;
  private final double[] gravity;

  /** Rotation body axes to world axes, 9 per link. */
  private final double[] rotation;

  /** Reference point from the world origin, m, 3 per link. */
  private final double[] position;

  private final double[] work = new double[12];

  WorldMotion(Mechanism mechanism) {
    tree = new TreeGeometry(mechanism);
    motion = new LinkMotion(tree);
    Root root = mechanism.root();
    Rotation r = root.orientation();
    rootRotation =
        new double[] {r.xx(), r.xy(), r.xz(), r.yx(), r.yy(), r.yz(), r.zx(), r.zy(), r.zz()};
    rootPosition = components(root.position());
    gravity = components(mechanism.gravity());
    rotation = new double[9 * tree.linkCount];
    position = new double[3 * tree.linkCount];
  }

  private static double[] components(Vector3 v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  /**
   * Sweeps outwards.
   *
   * @param y state [q; v]; not modified
   */
  void sweep(double[] y) {
    motion.sweep(y, tree.linkCount);
    for (int link = 0; link < tree.linkCount; link++) {
      int parent = tree.parent[link];
      boolean onRoot = parent == TreeGeometry.ROOT;
      double[] parentRotation = onRoot ? rootRotation : rotation;
      int parentAt = onRoot ? 0 : 9 * parent;
      multiply(parentRotation, parentAt, motion.rotation, 9 * link, rotation, 9 * link);
      apply(parentRotation, parentAt, motion.position, 3 * link, position, 3 * link);
      for (int i = 0; i < 3; i++) {
        position[3 * link + i] += onRoot ? rootPosition[i] : position[3 * parent + i];
      }
    }
  }

  /** Returns Σ ½ (m u_c² + ωᵀ I_c ω) after {@link #sweep}, J. */
  double kineticEnergy() {
    double twice = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      int at = 3 * link;
      double[] omega = motion.angularVelocity;
      System.arraycopy(motion.linearVelocity, at, work, 0, 3);
      addCross(omega, at, tree.centerOfMass, at, work, 0);
      twice += tree.mass[link] * dot(work, 0, work, 0);
      double[] i = tree.inertia;
      int ii = 6 * link;
      double x = omega[at];
      double y = omega[at + 1];
      double z = omega[at + 2];
      twice += i[ii] * x * x + i[ii + 1] * y * y + i[ii + 2] * z * z;
      twice += 2 * (i[ii + 3] * x * y + i[ii + 4] * x * z + i[ii + 5] * y * z);
    }
    return 0.5 * twice;
  }

  /** Returns −Σ m gᵀ p_c after {@link #sweep}, p_c from the world origin, J. */
  double potentialEnergy() {
    double sum = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      apply(rotation, 9 * link, tree.centerOfMass, 3 * link, work, 0);
      sum -= tree.mass[link] * (dot(gravity, 0, work, 0) + dot(gravity, 0, position, 3 * link));
    }
    return sum;
  }

  /**
   * Writes pose and velocity of every body frame after {@link #sweep}, as {@link
   * org.mechservice.solver.api.BodyPoses} says.
   *
   * @param poses 13 numbers per body in file order; overwritten
   */
  void poses(double[] poses) {
    for (int body = 0; body < tree.linkCount; body++) {
      int link = tree.linkOfBody[body];
      int at = 13 * body;
      apply(rotation, 9 * link, tree.bodyOrigin, 3 * link, poses, at);
      for (int i = 0; i < 3; i++) {
        poses[at + i] += position[3 * link + i];
      }
      EulerParameters.of(rotation, 9 * link, poses, at + 3);
      System.arraycopy(motion.linearVelocity, 3 * link, work, 0, 3);
      addCross(motion.angularVelocity, 3 * link, tree.bodyOrigin, 3 * link, work, 0);
      apply(rotation, 9 * link, work, 0, poses, at + 7);
      apply(rotation, 9 * link, motion.angularVelocity, 3 * link, poses, at + 10);
    }
  }
}
