package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.congruence;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Velocity derivative of the inertia force of each link with all links beyond it: the operator 2 B
 * = V ×* I − I V × + (·) ×* (I V), summed over the links, in link axes at the reference point.
 * Workspace of one thread.
 *
 * <p>Written out with I = [J, h×; −h×, m] and momentum I V = [n; l], most of it cancels: 2 B [ω; u]
 * = [T ω; −2 l × ω] with T = ω× J − J ω× − u× h× − h× u× − n×. The sum over links adds R T Rᵀ − 2
 * p× (R l)× and R l to the parent's T and l.
 */
final class VelocityDerivatives {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final LinkInertias inertias;

  /** T, kg·m²/s, 9 per link. */
  private final double[] turning;

  /** l, N·s, 3 per link. */
  private final double[] momentum;

  private final double[] work = new double[21];

  VelocityDerivatives(TreeMotion motion, LinkInertias inertias) {
    this.motion = motion;
    this.inertias = inertias;
    tree = motion.tree();
    turning = new double[9 * tree.linkCount];
    momentum = new double[3 * tree.linkCount];
  }

  /** Evaluates each link alone for the last sweep. */
  void formAlone() {
    for (int link = 0; link < tree.linkCount; link++) {
      start(link);
    }
  }

  /** Sums inwards for the last sweep. */
  void compose() {
    formAlone();
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        addToParent(link);
      }
    }
  }

  /** T = W + Wᵀ − h uᵀ − u hᵀ + 2 (h·u) 1 − n× with W = ω× J, since −J ω× = Wᵀ. */
  private void start(int link) {
    double[] omega = motion.angularVelocity;
    double[] u = motion.linearVelocity;
    double[] h = inertias.moment;
    inertias.momentum(link, omega, u, work, 0);
    System.arraycopy(work, 3, momentum, 3 * link, 3);
    for (int c = 0; c < 3; c++) {
      // column c of W; column c of J is its row c
      cross(omega, 3 * link, inertias.second, 9 * link + 3 * c, work, 6 + 3 * c);
    }
    double twice = 2 * dot(h, 3 * link, u, 3 * link);
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        turning[9 * link + 3 * r + c] =
            work[6 + 3 * c + r]
                + work[6 + 3 * r + c]
                - h[3 * link + r] * u[3 * link + c]
                - u[3 * link + r] * h[3 * link + c];
      }
      turning[9 * link + 4 * r] += twice;
    }
    subtractCrossMatrix(work, 0, turning, 9 * link);
  }

  /** M −= [a]×. */
  private static void subtractCrossMatrix(double[] a, int ia, double[] m, int im) {
    m[im + 1] += a[ia + 2];
    m[im + 2] -= a[ia + 1];
    m[im + 3] -= a[ia + 2];
    m[im + 5] += a[ia];
    m[im + 6] += a[ia + 1];
    m[im + 7] -= a[ia];
  }

  /** T_p += R T Rᵀ − 2 (l pᵀ − (p·l) 1), l_p += l, with l in parent axes. */
  private void addToParent(int link) {
    int parent = tree.parent[link];
    double[] p = motion.position;
    apply(motion.rotation, 9 * link, momentum, 3 * link, work, 0);
    congruence(motion.rotation, 9 * link, turning, 9 * link, work, 3, work, 12);
    double twice = 2 * dot(p, 3 * link, work, 0);
    for (int r = 0; r < 3; r++) {
      momentum[3 * parent + r] += work[r];
      for (int c = 0; c < 3; c++) {
        turning[9 * parent + 3 * r + c] += work[3 + 3 * r + c] - 2 * work[r] * p[3 * link + c];
      }
      turning[9 * parent + 4 * r] += twice;
    }
  }

  /** Adds 2 B x to out. */
  void addApplied(int link, double[] x, int ix, double[] out, int at) {
    apply(turning, 9 * link, x, ix, work, 0);
    cross(x, ix, momentum, 3 * link, work, 3);
    for (int i = 0; i < 3; i++) {
      out[at + i] += work[i];
      out[at + 3 + i] += 2 * work[3 + i];
    }
  }

  /** Writes (2 B)ᵀ x = [Tᵀ ω + 2 l × u; 0]; the three numbers that are not zero. */
  void applyTransposedTo(int link, double[] x, int ix, double[] out, int at) {
    cross(momentum, 3 * link, x, ix + 3, work, 0);
    applyTransposed(turning, 9 * link, x, ix, out, at);
    for (int i = 0; i < 3; i++) {
      out[at + i] += 2 * work[i];
    }
  }
}
