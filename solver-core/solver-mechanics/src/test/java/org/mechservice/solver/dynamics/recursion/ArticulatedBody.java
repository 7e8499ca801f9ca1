package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Joint accelerations of an open chain by the articulated-body algorithm written down a second
 * time, in the axes of the bodies and with general subspaces: a check of {@link TreeSteps}.
 *
 * <p>Three sweeps (Featherstone 2008, ch. 7; Bae and Haug 1987): velocities outwards, which {@link
 * TreeMotion} has done; articulated inertias and bias forces inwards; accelerations outwards.
 * Quantities of a link are in its axes at its reference point. A spatial vector is [angular;
 * linear]; an articulated inertia is [J, H; Hᵀ, M] in blocks of 3 × 3, so that [moment; force] = Iᴬ
 * [angular; linear] acceleration. Driven joints are not eliminated; their driving forces are
 * computed (hybrid dynamics, Featherstone 2008, §9.2).
 *
 * <p>Immutable; give each thread its own {@link Workspace}. Loops, and rods with mass, which couple
 * two bodies, are not supported: see {@link SemiRecursive} and closure.
 */
public final class ArticulatedBody {
  private final TreeGeometry tree;
  private final LinkInertias inertias;

  /** Prepares the recursion for a tree. */
  public ArticulatedBody(TreeGeometry tree) {
    this.tree = tree;
    inertias = new LinkInertias(tree);
  }

  /**
   * Returns new scratch for one thread.
   *
   * @param motion motion of the same tree, swept by the caller before each evaluation
   */
  public Workspace newWorkspace(TreeMotion motion) {
    return new Workspace(tree, inertias, motion);
  }

  /** Scratch of one thread; every field is overwritten by each evaluation. */
  public static final class Workspace {
    private final TreeMotion motion;
    private final ArticulatedInertias inertia;
    private final RigidComposites rigid;
    private final PivotCheck check = new PivotCheck();

    /** U = Iᴬ S, 6 per extended velocity. */
    private final double[] projected;

    /** D = Sᵀ U + the armature, one per extended velocity. */
    private final double[] pivot;

    /** u = τ − Sᵀ p, one per extended velocity. */
    private final double[] residual;

    /** Spatial acceleration including gravity, [angular; linear], 6 per link. */
    private final double[] acceleration;

    /** Driving force of each driven velocity, N·m or N. */
    private final double[] driving;

    private final double[] work = new double[6];

    private Workspace(TreeGeometry tree, LinkInertias inertias, TreeMotion motion) {
      this.motion = motion;
      inertia = new ArticulatedInertias(motion, inertias);
      rigid = new RigidComposites(tree, inertias);
      projected = new double[6 * tree.velocityCount];
      pivot = new double[tree.velocityCount];
      residual = new double[tree.velocityCount];
      acceleration = new double[6 * tree.linkCount];
      driving = new double[tree.velocityCount - tree.stateVelocityCount];
    }

    /** Returns the check of the pivots of the last evaluation. */
    public PivotCheck check() {
      return check;
    }

    /**
     * Returns the driving forces of the last evaluation, in addition to joint forces applied there,
     * in the order of the extended velocities, N·m or N; must not be modified.
     */
    public double[] drivingForces() {
      return driving;
    }
  }

  /**
   * Solves M(q) a + b(q, v) = τ + Jᵀ w for a swept motion.
   *
   * @param w scratch of this thread; overwritten
   * @param wrench external wrenches [moment; force] in link axes at the reference points, 6 per
   *     link, N·m, N; empty for none; not modified
   * @param tau joint forces, one per extended velocity, N·m or N; not modified
   * @param a joint accelerations in state order from {@code aAt}, rad/s² or m/s²; overwritten
   * @param aAt where the accelerations begin
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  public int accelerations(Workspace w, double[] wrench, double[] tau, double[] a, int aAt) {
    w.check.start();
    w.rigid.start();
    for (int link = 0; link < tree.linkCount; link++) {
      start(w, link);
    }
    for (int i = 0; i < wrench.length; i++) {
      w.inertia.bias[i] -= wrench[i];
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int singular = eliminate(w, link, tau);
      if (singular != ExplicitModel.REGULAR) {
        return singular;
      }
      if (tree.parent[link] != TreeGeometry.ROOT) {
        w.inertia.applyTo(link, w.motion.velocityProduct, 6 * link, w.work, 0);
        addScaled(w.inertia.bias, 6 * link, w.work, 0, 1);
        w.inertia.addToParent(link);
        w.rigid.addToParent(w.motion, link);
      }
    }
    for (int link = 0; link < tree.linkCount; link++) {
      accelerate(w, link, a, aAt);
    }
    return ExplicitModel.REGULAR;
  }

  /** Sets the link's own rigid-body inertia and V ×* (I V). */
  private void start(Workspace w, int link) {
    w.inertia.startAtRest(link);
    if (!inertias.massless[link]) {
      inertias.velocityForce(w.motion, link, w.work, w.inertia.bias);
    }
  }

  /**
   * Eliminates the freedoms of a link's joint from its articulated inertia, one after the other.
   */
  private int eliminate(Workspace w, int link, double[] tau) {
    int first = tree.velocityAt[link];
    int end = first + tree.kind[link].velocityCount();
    if (tree.driven[link]) {
      for (int k = first; k < end; k++) {
        formPivot(w, link, k, tau[k]);
      }
      for (int k = first; k < end; k++) {
        addScaled(w.inertia.bias, 6 * link, w.projected, 6 * k, w.motion.a[k]);
      }
      return ExplicitModel.REGULAR;
    }
    for (int k = first; k < end; k++) {
      formPivot(w, link, k, tau[k]);
      if (!w.check.regular(k, w.pivot[k], w.rigid.scale(link))) {
        return k;
      }
      double perPivot = 1 / w.pivot[k];
      if (tree.parent[link] != TreeGeometry.ROOT || k + 1 < end) {
        w.inertia.eliminate(link, w.projected, 6 * k, perPivot);
        addScaled(w.inertia.bias, 6 * link, w.projected, 6 * k, w.residual[k] * perPivot);
      }
    }
    return ExplicitModel.REGULAR;
  }

  /** U = Iᴬ S, D = Sᵀ U + the armature, u = τ − Sᵀ p. */
  private void formPivot(Workspace w, int link, int k, double tau) {
    double[] s = w.motion.subspace;
    int at = 6 * k;
    if (tree.kind[link] == LinkKind.SLIDE) {
      w.inertia.applyToSliding(link, s, at + 3, w.projected, at);
      w.pivot[k] = dot(s, at + 3, w.projected, at + 3) + tree.armature[k];
      w.residual[k] = tau - dot(s, at + 3, w.inertia.bias, 6 * link + 3);
    } else if (tree.kind[link] == LinkKind.SCREW) {
      w.inertia.applyTo(link, s, at, w.projected, at);
      w.pivot[k] = dot6(s, at, w.projected, at) + tree.armature[k];
      w.residual[k] = tau - dot6(s, at, w.inertia.bias, 6 * link);
    } else {
      w.inertia.applyToTurning(link, s, at, w.projected, at);
      w.pivot[k] = dot(s, at, w.projected, at) + tree.armature[k];
      w.residual[k] = tau - dot(s, at, w.inertia.bias, 6 * link);
    }
  }

  /** A' = X A_p + c; then a = (u − Uᵀ A') / D, A' += S a for each freedom, the last taken first. */
  private void accelerate(Workspace w, int link, double[] a, int aAt) {
    carryAcceleration(w, link);
    int first = tree.velocityAt[link];
    double[] acceleration = w.acceleration;
    int end = first + tree.kind[link].velocityCount();
    if (tree.driven[link]) {
      for (int k = first; k < end; k++) {
        addScaled(acceleration, 6 * link, w.motion.subspace, 6 * k, w.motion.a[k]);
      }
      for (int k = first; k < end; k++) {
        w.driving[k - tree.stateVelocityCount] =
            dot6(w.projected, 6 * k, acceleration, 6 * link)
                - w.residual[k]
                + tree.armature[k] * w.motion.a[k];
      }
      return;
    }
    for (int k = end - 1; k >= first; k--) {
      double known = dot6(w.projected, 6 * k, acceleration, 6 * link);
      a[aAt + k] = (w.residual[k] - known) / w.pivot[k];
      addScaled(acceleration, 6 * link, w.motion.subspace, 6 * k, a[aAt + k]);
    }
  }

  private void carryAcceleration(Workspace w, int link) {
    int at = 6 * link;
    double[] acceleration = w.acceleration;
    double[] rotation = w.motion.rotation;
    double[] carried = w.work;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      for (int i = 0; i < 3; i++) {
        carried[i] = 0 - tree.gravityInRoot[i];
      }
      Arrays.fill(acceleration, at, at + 3, 0);
      applyTransposed(rotation, 9 * link, carried, 0, acceleration, at + 3);
    } else {
      applyTransposed(rotation, 9 * link, acceleration, 6 * parent, acceleration, at);
      System.arraycopy(acceleration, 6 * parent + 3, carried, 0, 3);
      addCross(acceleration, 6 * parent, w.motion.position, 3 * link, carried, 0);
      applyTransposed(rotation, 9 * link, carried, 0, acceleration, at + 3);
    }
    for (int i = at; i < at + 6; i++) {
      acceleration[i] += w.motion.velocityProduct[i];
    }
  }

  private static void addScaled(double[] sum, int is, double[] x, int ix, double factor) {
    for (int i = 0; i < 6; i++) {
      sum[is + i] += factor * x[ix + i];
    }
  }

  private static double dot6(double[] a, int ia, double[] b, int ib) {
    return dot(a, ia, b, ib) + dot(a, ia + 3, b, ib + 3);
  }
}
