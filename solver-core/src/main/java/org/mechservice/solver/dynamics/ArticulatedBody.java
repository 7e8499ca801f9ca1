package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.congruence;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.crossColumns;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Vector3;

/**
 * DTR: joint accelerations of an open chain by articulated bodies, O(n), without forming the mass
 * matrix.
 *
 * <p>Three sweeps (Featherstone 2008, ch. 7; Bae and Haug 1987): velocities outwards; articulated
 * inertias and bias forces inwards; accelerations outwards. Quantities of a link are in its body
 * axes at its reference point. A spatial vector is [angular; linear]; an articulated inertia is [J,
 * H; Hᵀ, M] in blocks of 3 × 3, so that [moment; force] = Iᴬ [angular; linear] acceleration.
 *
 * <p>Immutable; give each thread its own {@link Workspace}. Does not hold loops: see closure.
 */
public final class ArticulatedBody {
  /**
   * A pivot this small against the inertia of all that lies beyond the joint, taken as one rigid
   * body, counts as zero (NUMERICS §2): at gimbal lock, say, the joints between leave nothing of it
   * but rounding.
   */
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  private final TreeGeometry tree;
  private final double[] rootAcceleration;

  /**
   * Prepares the recursion for a mechanism.
   *
   * @param mechanism an open chain of R and P joints
   */
  public ArticulatedBody(Mechanism mechanism) {
    tree = new TreeGeometry(mechanism);
    Vector3 up = mechanism.root().orientation().transposed().apply(mechanism.gravity().negated());
    rootAcceleration = new double[] {up.x(), up.y(), up.z()};
  }

  /** Returns new scratch for one thread. */
  public Workspace newWorkspace() {
    return new Workspace(tree);
  }

  /** Scratch of one thread; every field is overwritten by each evaluation. */
  public static final class Workspace {
    private final LinkMotion motion;

    /** Blocks J, H and M of the articulated inertia, 9 per link; kg·m², kg·m, kg. */
    private final double[] inertiaJ;

    private final double[] inertiaH;
    private final double[] inertiaM;

    /** Bias force, [moment; force], 6 per link. */
    private final double[] bias;

    /** Velocity product [angular; linear] of the joint, 6 per link. */
    private final double[] product;

    /** U = Iᴬ S, 6 per link. */
    private final double[] projected;

    /** D = Sᵀ U. */
    private final double[] pivot;

    /**
     * Mass, first moment (3 per link) and twice the trace of the second moment, which is the trace
     * of the inertia, of all bodies beyond a joint taken as one: what a pivot is judged by; kg,
     * kg·m, kg·m².
     */
    private final double[] rigidMass;

    private final double[] rigidMoment;
    private final double[] rigidTrace;

    /** u = τ − Sᵀ p. */
    private final double[] residual;

    /** Spatial acceleration, [angular; linear], 6 per link. */
    private final double[] acceleration;

    private final double[] work = new double[36];

    private Workspace(TreeGeometry tree) {
      int n = tree.linkCount;
      motion = new LinkMotion(tree);
      inertiaJ = new double[9 * n];
      inertiaH = new double[9 * n];
      inertiaM = new double[9 * n];
      bias = new double[6 * n];
      product = new double[6 * n];
      projected = new double[6 * n];
      pivot = new double[n];
      rigidMass = new double[n];
      rigidMoment = new double[3 * n];
      rigidTrace = new double[n];
      residual = new double[n];
      acceleration = new double[6 * n];
    }
  }

  /**
   * Solves M(q) a + b(q, v) = τ.
   *
   * @param w scratch of this thread; overwritten
   * @param y state [q; v], rad, m, rad/s, m/s; not modified
   * @param tau joint forces, N·m or N; not modified
   * @param a joint accelerations from {@code aAt}, rad/s² or m/s²; overwritten
   * @param aAt where the accelerations begin
   * @return {@link ExplicitModel#REGULAR}, or the index of the joint beyond which there is no
   *     inertia
   */
  public int accelerations(Workspace w, double[] y, double[] tau, double[] a, int aAt) {
    w.motion.sweep(y, tree.linkCount);
    for (int link = 0; link < tree.linkCount; link++) {
      startLink(w, link, y[tree.linkCount + tree.coordinate[link]]);
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      formPivot(w, link, tau[tree.coordinate[link]]);
      double rigid = tree.slides[link] ? w.rigidMass[link] : w.rigidTrace[link];
      if (!(w.pivot[link] > SINGULAR * rigid)) {
        return tree.joint[link];
      }
      if (tree.parent[link] != TreeGeometry.ROOT) {
        projectToParent(w, link);
      }
    }
    for (int link = 0; link < tree.linkCount; link++) {
      a[aAt + tree.coordinate[link]] = accelerate(w, link);
    }
    return ExplicitModel.REGULAR;
  }

  /**
   * Rigid-body inertia about the reference point, bias force V ×* (I V), velocity product V × S q'.
   */
  private void startLink(Workspace w, int link, double rate) {
    double[] omega = w.motion.angularVelocity;
    double[] u = w.motion.linearVelocity;
    int at = 3 * link;
    rigidInertia(w, link);
    // momentum [h; l] = I V, bias = [ω × h + u × l; ω × l]
    double[] momentum = w.work;
    apply(w.inertiaJ, 9 * link, omega, at, momentum, 0);
    apply(w.inertiaH, 9 * link, u, at, momentum, 6);
    applyTransposed(w.inertiaH, 9 * link, omega, at, momentum, 3);
    for (int i = 0; i < 3; i++) {
      momentum[i] += momentum[6 + i];
      momentum[3 + i] += tree.mass[link] * u[at + i];
    }
    cross(omega, at, momentum, 0, w.bias, 2 * at);
    addCross(u, at, momentum, 3, w.bias, 2 * at);
    cross(omega, at, momentum, 3, w.bias, 2 * at + 3);
    // c = [ω × s; u × s] q' for a turning joint, [0; ω × s] q' for a sliding one
    Arrays.fill(w.product, 2 * at, 2 * at + 6, 0);
    if (tree.slides[link]) {
      cross(omega, at, tree.axisInChild, at, w.product, 2 * at + 3);
    } else {
      cross(omega, at, tree.axisInChild, at, w.product, 2 * at);
      cross(u, at, tree.axisInChild, at, w.product, 2 * at + 3);
    }
    for (int i = 2 * at; i < 2 * at + 6; i++) {
      w.product[i] *= rate;
    }
    w.rigidMass[link] = tree.mass[link];
    w.rigidTrace[link] = w.inertiaJ[9 * link] + w.inertiaJ[9 * link + 4] + w.inertiaJ[9 * link + 8];
    for (int i = at; i < at + 3; i++) {
      w.rigidMoment[i] = tree.mass[link] * tree.centerOfMass[i];
    }
  }

  /** J = I_c − m [c]×[c]×, H = m [c]×, M = m 1. */
  private void rigidInertia(Workspace w, int link) {
    double m = tree.mass[link];
    double x = tree.centerOfMass[3 * link];
    double y = tree.centerOfMass[3 * link + 1];
    double z = tree.centerOfMass[3 * link + 2];
    double[] i = tree.inertia;
    int ii = 6 * link;
    setSymmetric(
        w.inertiaJ,
        9 * link,
        i[ii] + m * (y * y + z * z),
        i[ii + 1] + m * (x * x + z * z),
        i[ii + 2] + m * (x * x + y * y),
        i[ii + 3] - m * x * y,
        i[ii + 4] - m * x * z,
        i[ii + 5] - m * y * z);
    double[] h = w.inertiaH;
    int ih = 9 * link;
    Arrays.fill(h, ih, ih + 9, 0);
    h[ih + 1] = -m * z;
    h[ih + 2] = m * y;
    h[ih + 3] = m * z;
    h[ih + 5] = -m * x;
    h[ih + 6] = -m * y;
    h[ih + 7] = m * x;
    setSymmetric(w.inertiaM, 9 * link, m, m, m, 0, 0, 0);
  }

  private static void setSymmetric(
      double[] s, int at, double xx, double yy, double zz, double xy, double xz, double yz) {
    s[at] = xx;
    s[at + 1] = xy;
    s[at + 2] = xz;
    s[at + 3] = xy;
    s[at + 4] = yy;
    s[at + 5] = yz;
    s[at + 6] = xz;
    s[at + 7] = yz;
    s[at + 8] = zz;
  }

  /** U = Iᴬ S, D = Sᵀ U, u = τ − Sᵀ p. */
  private void formPivot(Workspace w, int link, double tau) {
    int at = 6 * link;
    if (tree.slides[link]) {
      apply(w.inertiaH, 9 * link, tree.axisInChild, 3 * link, w.projected, at);
      apply(w.inertiaM, 9 * link, tree.axisInChild, 3 * link, w.projected, at + 3);
    } else {
      apply(w.inertiaJ, 9 * link, tree.axisInChild, 3 * link, w.projected, at);
      applyTransposed(w.inertiaH, 9 * link, tree.axisInChild, 3 * link, w.projected, at + 3);
    }
    int moving = tree.slides[link] ? at + 3 : at;
    w.pivot[link] = dot(tree.axisInChild, 3 * link, w.projected, moving);
    w.residual[link] = tau - dot(tree.axisInChild, 3 * link, w.bias, moving);
  }

  /** Adds X*(Iᴬ − U D⁻¹ Uᵀ)X and X*(p + Iᴬ c − U D⁻¹ Uᵀ c + U D⁻¹ u) to the parent. */
  private void projectToParent(Workspace w, int link) {
    double perPivot = 1 / w.pivot[link];
    rankOneDown(w, link, perPivot);
    projectBias(w, link, perPivot);
    rotateToParent(w, link);
    shiftToParent(w, link);
    addRigidToParent(w, link);
  }

  private static void rankOneDown(Workspace w, int link, double perPivot) {
    int at = 6 * link;
    for (int i = 0; i < 3; i++) {
      double angular = w.projected[at + i] * perPivot;
      double linear = w.projected[at + 3 + i] * perPivot;
      for (int j = 0; j < 3; j++) {
        w.inertiaJ[9 * link + 3 * i + j] -= angular * w.projected[at + j];
        w.inertiaH[9 * link + 3 * i + j] -= angular * w.projected[at + 3 + j];
        w.inertiaM[9 * link + 3 * i + j] -= linear * w.projected[at + 3 + j];
      }
    }
  }

  private static void projectBias(Workspace w, int link, double perPivot) {
    int at = 6 * link;
    double[] f = w.work;
    apply(w.inertiaJ, 9 * link, w.product, at, f, 0);
    apply(w.inertiaH, 9 * link, w.product, at + 3, f, 3);
    applyTransposed(w.inertiaH, 9 * link, w.product, at, f, 6);
    apply(w.inertiaM, 9 * link, w.product, at + 3, f, 9);
    double gain = w.residual[link] * perPivot;
    for (int i = 0; i < 3; i++) {
      w.bias[at + i] += f[i] + f[3 + i] + gain * w.projected[at + i];
      w.bias[at + 3 + i] += f[6 + i] + f[9 + i] + gain * w.projected[at + 3 + i];
    }
  }

  /** Turns inertia blocks, bias and U into parent axes, in place. */
  private static void rotateToParent(Workspace w, int link) {
    double[] r = w.motion.rotation;
    congruence(r, 9 * link, w.inertiaJ, 9 * link, w.inertiaJ, 9 * link, w.work, 0);
    congruence(r, 9 * link, w.inertiaH, 9 * link, w.inertiaH, 9 * link, w.work, 0);
    congruence(r, 9 * link, w.inertiaM, 9 * link, w.inertiaM, 9 * link, w.work, 0);
    rotateInPlace(r, 9 * link, w.bias, 6 * link, w.work);
    rotateInPlace(r, 9 * link, w.bias, 6 * link + 3, w.work);
  }

  private static void rotateInPlace(double[] r, int ir, double[] v, int iv, double[] work) {
    apply(r, ir, v, iv, work, 0);
    System.arraycopy(work, 0, v, iv, 3);
  }

  /**
   * Moves the inertia from the link's point to the parent's and adds it: with the point at p, H_p =
   * H + [p]× M, J_p = J + [p]× Hᵀ + ([p]× Hᵀ)ᵀ − [p]× M [p]×.
   */
  private void shiftToParent(Workspace w, int link) {
    int parent = tree.parent[link];
    double[] p = w.motion.position;
    double[] work = w.work;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        work[3 * i + j] = w.inertiaH[9 * link + 3 * j + i];
      }
    }
    crossColumns(p, 3 * link, work, 0, work, 27);
    crossColumns(p, 3 * link, w.inertiaM, 9 * link, work, 0);
    for (int i = 0; i < 3; i++) {
      // −[p]× M [p]×, row i: p × (row i of [p]× M)
      cross(p, 3 * link, work, 3 * i, work, 9 + 3 * i);
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        int ij = 3 * i + j;
        w.inertiaJ[9 * parent + ij] +=
            w.inertiaJ[9 * link + ij] + work[27 + ij] + work[27 + 3 * j + i] + work[9 + ij];
        w.inertiaH[9 * parent + ij] += w.inertiaH[9 * link + ij] + work[ij];
        w.inertiaM[9 * parent + ij] += w.inertiaM[9 * link + ij];
      }
      w.bias[6 * parent + i] += w.bias[6 * link + i];
      w.bias[6 * parent + 3 + i] += w.bias[6 * link + 3 + i];
    }
    addCross(p, 3 * link, w.bias, 6 * link + 3, w.bias, 6 * parent);
  }

  /** With the link's point at p: m, R h + m p, tr J + 4 pᵀ R h + 2 m pᵀ p. */
  private void addRigidToParent(Workspace w, int link) {
    int parent = tree.parent[link];
    double[] p = w.motion.position;
    double[] h = w.work;
    double m = w.rigidMass[link];
    apply(w.motion.rotation, 9 * link, w.rigidMoment, 3 * link, h, 0);
    w.rigidMass[parent] += m;
    w.rigidTrace[parent] +=
        w.rigidTrace[link] + 4 * dot(p, 3 * link, h, 0) + 2 * m * dot(p, 3 * link, p, 3 * link);
    for (int i = 0; i < 3; i++) {
      w.rigidMoment[3 * parent + i] += h[i] + m * p[3 * link + i];
    }
  }

  /** A' = X A_p + c, a = (u − Uᵀ A') / D, A = A' + S a. */
  private double accelerate(Workspace w, int link) {
    int at = 6 * link;
    double[] a = w.acceleration;
    double[] carried = w.work;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      Arrays.fill(a, at, at + 3, 0);
      applyTransposed(w.motion.rotation, 9 * link, rootAcceleration, 0, a, at + 3);
    } else {
      applyTransposed(w.motion.rotation, 9 * link, a, 6 * parent, a, at);
      System.arraycopy(a, 6 * parent + 3, carried, 0, 3);
      addCross(a, 6 * parent, w.motion.position, 3 * link, carried, 0);
      applyTransposed(w.motion.rotation, 9 * link, carried, 0, a, at + 3);
    }
    double known = 0;
    for (int i = at; i < at + 6; i++) {
      a[i] += w.product[i];
      known += w.projected[i] * a[i];
    }
    double joint = (w.residual[link] - known) / w.pivot[link];
    int moving = tree.slides[link] ? at + 3 : at;
    for (int i = 0; i < 3; i++) {
      a[moving + i] += joint * tree.axisInChild[3 * link + i];
    }
    return joint;
  }
}
