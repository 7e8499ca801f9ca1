package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * How motions of the links change with each coordinate and velocity: ψ' = V_p × S, ψ'' = A_p × S +
 * V_p × ψ' and ψ' + S' for each column S, in link axes (Singh, Russell and Wensing 2022). Workspace
 * of one thread.
 */
final class MotionColumns {
  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final NewtonEuler newtonEuler;

  /** ψ', ψ'' and ψ' + S', 6 per extended velocity. */
  final double[] first;

  final double[] second;
  final double[] both;

  /** Velocity and acceleration of the parent in link axes, [angular; linear]. */
  private final double[] parentVelocity = new double[6];

  private final double[] parentAcceleration = new double[6];
  private final double[] work = new double[6];

  /**
   * @param newtonEuler evaluated by the caller before, for the acceleration of free fall
   */
  MotionColumns(TreeMotion motion, NewtonEuler newtonEuler) {
    this.motion = motion;
    this.newtonEuler = newtonEuler;
    tree = motion.tree();
    first = new double[6 * tree.velocityCount];
    second = new double[6 * tree.velocityCount];
    both = new double[6 * tree.velocityCount];
  }

  /** Forms the columns of a link; driven ones have none. */
  void form(int link) {
    if (tree.driven[link]) {
      return;
    }
    carryParent(link);
    int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
    for (int k = tree.velocityAt[link]; k < end; k++) {
      double[] s = motion.subspace;
      crossMotion(parentVelocity, 0, s, 6 * k, first, 6 * k);
      crossMotion(parentVelocity, 0, first, 6 * k, second, 6 * k);
      crossMotion(parentAcceleration, 0, s, 6 * k, work, 0);
      crossMotion(motion.relativeVelocity, 6 * link, s, 6 * k, both, 6 * k);
      for (int i = 0; i < 6; i++) {
        second[6 * k + i] += work[i];
        both[6 * k + i] += 2 * first[6 * k + i];
      }
    }
  }

  /** Writes V_p and A_p, seen at the link in its axes; gravity is in A_p. */
  private void carryParent(int link) {
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      Arrays.fill(parentVelocity, 0);
      Arrays.fill(parentAcceleration, 0);
    } else {
      carry(link, motion.angularVelocity, motion.linearVelocity, parentVelocity);
      carry(link, motion.angularAcceleration, motion.linearAcceleration, parentAcceleration);
    }
    for (int i = 0; i < 3; i++) {
      parentAcceleration[3 + i] -= newtonEuler.gravity[3 * link + i];
    }
  }

  private void carry(int link, double[] angular, double[] linear, double[] out) {
    int parent = tree.parent[link];
    applyTransposed(motion.rotation, 9 * link, angular, 3 * parent, out, 0);
    System.arraycopy(linear, 3 * parent, work, 0, 3);
    addCross(angular, 3 * parent, motion.position, 3 * link, work, 0);
    applyTransposed(motion.rotation, 9 * link, work, 0, out, 3);
  }

  /** out = a × b = [ω_a × ω_b; ω_a × u_b + u_a × ω_b]. */
  private static void crossMotion(double[] a, int ia, double[] b, int ib, double[] out, int at) {
    cross(a, ia, b, ib, out, at);
    cross(a, ia, b, ib + 3, out, at + 3);
    addCross(a, ia + 3, b, ib, out, at + 3);
  }
}
