package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.recursion.CompositeInertias;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * DSR: joint accelerations by composite inertias. The mass matrix M is formed only between each
 * joint and its ancestors, and factored as LᵀDL along the tree without fill-in (Featherstone 2008,
 * §6.2 and §6.5); b comes from one Newton-Euler sweep. A rod with mass adds the elements between
 * the ancestors of its two ends.
 *
 * <p>Immutable; give each thread its own {@link Workspace}.
 */
public final class SemiRecursive {
  private final TreeGeometry tree;
  private final LinkInertias inertias;
  private final TreePattern pattern;

  /** Prepares the formulation for an open tree and its rods with mass. */
  public SemiRecursive(TreeGeometry tree) {
    this.tree = tree;
    inertias = new LinkInertias(tree);
    pattern = new TreePattern(tree, new MassiveRods(tree).pairs());
  }

  /**
   * Returns new scratch for one thread.
   *
   * @param motion motion of the same tree, swept by the caller before each evaluation
   */
  public Workspace newWorkspace(TreeMotion motion) {
    return new Workspace(tree, inertias, pattern, motion);
  }

  /** Scratch of one thread. */
  public static final class Workspace implements OpenTree {
    private final TreeGeometry tree;
    private final TreePattern pattern;
    private final TreeMotion motion;
    private final CompositeInertias composites;
    private final NewtonEuler newtonEuler;
    private final PivotCheck check = new PivotCheck();
    private final MassiveRods rods;
    private final TreeMatrix mass;

    /** Reference size of each pivot, one per velocity of the state. */
    private final double[] scale;

    /** b − τ, one per extended velocity. */
    private final double[] bias;

    private final double[] noAcceleration;

    /** External wrenches and those of rods, 6 per link. */
    private final double[] loads;

    private final double[] work = new double[6];

    private Workspace(
        TreeGeometry tree, LinkInertias inertias, TreePattern pattern, TreeMotion motion) {
      this.tree = tree;
      this.pattern = pattern;
      this.motion = motion;
      composites = new CompositeInertias(motion, inertias);
      newtonEuler = new NewtonEuler(motion, inertias);
      mass = new TreeMatrix(pattern);
      scale = new double[tree.stateVelocityCount];
      bias = new double[tree.velocityCount];
      noAcceleration = new double[tree.stateVelocityCount];
      rods = new MassiveRods(tree);
      loads = new double[rods.isEmpty() ? 0 : 6 * tree.linkCount];
    }

    @Override
    public TreeMotion motion() {
      return motion;
    }

    @Override
    public TreeMatrix massMatrix() {
      return mass;
    }

    @Override
    public double[] bias() {
      return bias;
    }

    @Override
    public PivotCheck check() {
      return check;
    }

    @Override
    public void formMassMatrix() {
      composites.compose();
      mass.clear();
      for (int place = 0; place < pattern.size; place++) {
        formRow(place);
      }
      if (!rods.isEmpty()) {
        rods.addMass(motion, mass);
        for (int place = 0; place < pattern.size; place++) {
          int k = pattern.velocityAt[place];
          scale[k] = Math.max(scale[k], mass.diagonal()[place]);
        }
      }
    }

    /** Forms M_kj = S_jᵀ X* I S_k for all ancestors j of k. */
    private void formRow(int place) {
      int k = pattern.velocityAt[place];
      int link = tree.linkOfVelocity[k];
      composites.applyTo(link, motion.subspace, 6 * k, work, 0);
      mass.setDiagonal(place, product(k) + tree.armature[k]);
      scale[k] = composites.scale(link);
      for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
        if (!tree.driven[i]) {
          for (int j = tree.velocityAt[i]; j < endOf(i, link, k); j++) {
            mass.setElement(pattern.find(place, pattern.placeOf[j]), product(j));
          }
        }
        motion.wrenches.toParent(i, work, 0);
      }
    }

    /**
     * Returns the end of the row's velocities in a link; in the link of velocity k, only those
     * before k.
     */
    private int endOf(int i, int link, int k) {
      return i == link ? k : tree.velocityAt[i] + tree.kind[i].velocityCount();
    }

    private double product(int j) {
      double[] s = motion.subspace;
      return dot(s, 6 * j, work, 0) + dot(s, 6 * j + 3, work, 3);
    }

    @Override
    public void formBias(double[] wrench, double[] tau) {
      motion.accelerationSweep(noAcceleration);
      formResidual(wrench, tau, bias);
    }

    @Override
    public void formResidual(double[] wrench, double[] tau, double[] residual) {
      if (rods.isEmpty()) {
        newtonEuler.evaluate(wrench, tau, residual);
        return;
      }
      Arrays.fill(loads, 0);
      System.arraycopy(wrench, 0, loads, 0, wrench.length);
      rods.addForces(motion, loads);
      newtonEuler.evaluate(loads, tau, residual);
    }

    @Override
    public int factorMassMatrix() {
      return mass.factor(check, scale);
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
    w.formMassMatrix();
    w.formBias(wrench, tau);
    int singular = w.factorMassMatrix();
    if (singular == ExplicitModel.REGULAR) {
      for (int i = 0; i < tree.stateVelocityCount; i++) {
        a[aAt + i] = 0 - w.bias[i];
      }
      w.mass.solve(a, aAt);
    }
    return singular;
  }
}
