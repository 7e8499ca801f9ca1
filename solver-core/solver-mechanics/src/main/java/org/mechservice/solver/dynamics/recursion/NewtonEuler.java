package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The inward sweep of the recursive Newton-Euler algorithm: the joint forces of a given motion.
 * Workspace of one thread.
 *
 * <p>f = I A + V ×* (I V) − w + Σ X* f of the children, with gravity as an acceleration of the
 * root; the joint force is Sᵀ f, and the armature times the joint acceleration.
 */
public final class NewtonEuler {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final LinkInertias inertias;

  /** Force that the parent exerts on the link, [moment; force], 6 per link, N·m, N. */
  public final double[] force;

  /** Acceleration of free fall in link axes, m/s², 3 per link. */
  public final double[] gravity;

  private final double[] work = new double[6];

  public NewtonEuler(TreeMotion motion, LinkInertias inertias) {
    this.motion = motion;
    this.inertias = inertias;
    tree = motion.tree();
    force = new double[6 * tree.linkCount];
    gravity = new double[3 * tree.linkCount];
  }

  /**
   * Evaluates M a + b − τ for the accelerations of the last {@link TreeMotion#accelerationSweep}.
   *
   * @param wrench external wrenches, 6 per link, or empty; not modified
   * @param tau joint forces, one per extended velocity; not modified
   * @param residual one number per extended velocity, N·m or N; overwritten; entries of driven
   *     velocities are the driving forces
   */
  public void evaluate(double[] wrench, double[] tau, double[] residual) {
    for (int link = 0; link < tree.linkCount; link++) {
      fall(link);
      inertiaForce(link);
    }
    for (int i = 0; i < wrench.length; i++) {
      force[i] -= wrench[i];
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
      for (int k = tree.velocityAt[link]; k < end; k++) {
        double sum = 0;
        for (int i = 0; i < 6; i++) {
          sum += motion.subspace[6 * k + i] * force[6 * link + i];
        }
        residual[k] = sum - tau[k];
        if (tree.armature[k] != 0) {
          residual[k] += tree.armature[k] * motion.a[k];
        }
      }
      if (tree.parent[link] != TreeGeometry.ROOT) {
        addToParent(link);
      }
    }
  }

  private void fall(int link) {
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      applyTransposed(motion.rotation, 9 * link, tree.gravityInRoot, 0, gravity, 3 * link);
    } else {
      applyTransposed(motion.rotation, 9 * link, gravity, 3 * parent, gravity, 3 * link);
    }
  }

  /** f = I (A − g) + V ×* (I V). */
  private void inertiaForce(int link) {
    int at = 6 * link;
    if (inertias.massless[link]) {
      Arrays.fill(force, at, at + 6, 0);
      return;
    }
    inertias.velocityForce(motion, link, work, force);
    double m = inertias.mass[link];
    for (int i = 0; i < 3; i++) {
      work[i] = motion.linearAcceleration[3 * link + i] - gravity[3 * link + i];
      force[at + 3 + i] += m * work[i];
    }
    addCross(inertias.moment, 3 * link, work, 0, force, at);
    apply(inertias.second, 9 * link, motion.angularAcceleration, 3 * link, work, 0);
    cross(motion.angularAcceleration, 3 * link, inertias.moment, 3 * link, work, 3);
    for (int i = 0; i < 6; i++) {
      force[at + i] += work[i];
    }
  }

  private void addToParent(int link) {
    System.arraycopy(force, 6 * link, work, 0, 6);
    motion.wrenches.toParent(link, work, 0);
    for (int i = 0; i < 6; i++) {
      force[6 * tree.parent[link] + i] += work[i];
    }
  }
}
