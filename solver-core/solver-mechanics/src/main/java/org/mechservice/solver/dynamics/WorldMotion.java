package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.spatial.EulerParameters;

/** Poses, velocities and energies of the bodies in the world. Workspace of one thread. */
public final class WorldMotion {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final double[] work = new double[12];

  /**
   * @param motion swept by the caller before each evaluation
   */
  public WorldMotion(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
  }

  /** Returns Σ ½ (m u_c² + ωᵀ I_c ω), and ½ A v² of each armature, J. */
  public double kineticEnergy() {
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
    for (int k = 0; k < tree.velocityCount; k++) {
      twice += tree.armature[k] * motion.v[k] * motion.v[k];
    }
    return 0.5 * twice;
  }

  /** Returns −Σ m gᵀ p_c, p_c from the world origin, J. */
  public double potentialEnergy() {
    double sum = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      apply(motion.worldRotation, 9 * link, tree.centerOfMass, 3 * link, work, 0);
      sum -=
          tree.mass[link]
              * (dot(tree.gravity, 0, work, 0)
                  + dot(tree.gravity, 0, motion.worldPosition, 3 * link));
    }
    return sum;
  }

  /**
   * Writes pose and velocity of every body frame, as {@link
   * org.mechservice.solver.api.capability.BodyPoses} says.
   *
   * @param poses 13 numbers per body in file order; overwritten
   */
  public void poses(double[] poses) {
    for (int body = 0; body < tree.linkOfBody.length; body++) {
      int link = tree.linkOfBody[body];
      int at = 13 * body;
      apply(motion.worldRotation, 9 * link, tree.bodyOrigin, 3 * link, poses, at);
      for (int i = 0; i < 3; i++) {
        poses[at + i] += motion.worldPosition[3 * link + i];
      }
      EulerParameters.of(motion.worldRotation, 9 * link, poses, at + 3);
      System.arraycopy(motion.linearVelocity, 3 * link, work, 0, 3);
      addCross(motion.angularVelocity, 3 * link, tree.bodyOrigin, 3 * link, work, 0);
      apply(motion.worldRotation, 9 * link, work, 0, poses, at + 7);
      apply(motion.worldRotation, 9 * link, motion.angularVelocity, 3 * link, poses, at + 10);
    }
  }
}
