package org.mechservice.solver.dynamics;

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
 * The equations of an open tree, M(q) a + b(q, v) = τ + Jᵀ w, semi-recursively (DSR). M comes from
 * composite inertias and is formed only between each joint and its ancestors, and factored as LᵀDL
 * along the tree without fill-in (Featherstone 2008, §6.2 and §6.5); b comes from one Newton-Euler
 * sweep. A rod with mass adds the elements between the ancestors of its two ends.
 *
 * <p>Coordinates are those of the last sweep of a {@link TreeMotion}. Wrenches are [moment; force]
 * in link axes at the reference points, 6 per link, N·m, N, or empty for none; joint forces τ one
 * per extended velocity, N·m or N. Neither is modified.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class SemiRecursive {
  private static final double[] NONE = {};

  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final CompositeInertias composites;
  private final NewtonEuler newtonEuler;
  private final MassiveRods rods;
  private final TreePattern pattern;
  private final TreeMatrix mass;
  private final PivotCheck check = new PivotCheck();

  /** Reference size of each pivot, one per velocity of the state. */
  private final double[] size;

  /** b − τ, one per extended velocity. */
  private final double[] bias;

  private final double[] noAcceleration;

  /** External wrenches and those of rods, 6 per link. */
  private final double[] loads;

  /**
   * Prepares the equations of a tree and its rods with mass.
   *
   * @param motion swept by the caller before each evaluation
   */
  public SemiRecursive(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
    LinkInertias inertias = new LinkInertias(tree);
    composites = new CompositeInertias(motion, inertias);
    newtonEuler = new NewtonEuler(motion, inertias);
    rods = new MassiveRods(tree);
    pattern = new TreePattern(tree, rods.pairs());
    mass = new TreeMatrix(pattern);
    size = new double[tree.stateVelocityCount];
    bias = new double[tree.velocityCount];
    noAcceleration = new double[tree.stateVelocityCount];
    loads = new double[rods.isEmpty() ? 0 : 6 * tree.linkCount];
  }

  /** Forms M. */
  public void formMassMatrix() {
    composites.formMass(pattern, mass);
    for (int k = 0; k < size.length; k++) {
      size[k] = composites.scale(tree.linkOfVelocity[k]);
    }
    if (!rods.isEmpty()) {
      rods.addMass(motion, mass);
      for (int place = 0; place < pattern.size; place++) {
        int k = pattern.velocityAt[place];
        size[k] = Math.max(size[k], mass.diagonal()[place]);
      }
    }
  }

  /** Returns M, or its factors after {@link #factorMassMatrix}. */
  public TreeMatrix massMatrix() {
    return mass;
  }

  /**
   * Overwrites M by its factors.
   *
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  public int factorMassMatrix() {
    return mass.factor(check, size);
  }

  /** Returns the check of the pivots of the last factorisation of M. */
  public PivotCheck check() {
    return check;
  }

  /**
   * Forms b − τ − Jᵀ w; b includes the prescribed accelerations of driven joints. The motion's
   * accelerations are swept, with zero for all states.
   */
  public void formBias(double[] wrench, double[] tau) {
    formResidual(wrench, tau, noAcceleration, 0, bias);
  }

  /** Returns the b − τ − Jᵀ w formed last, one per extended velocity; not to be modified. */
  public double[] bias() {
    return bias;
  }

  /**
   * Sweeps the motion's accelerations and evaluates M a + b − τ − Jᵀ w by one sweep inwards; M need
   * not be formed.
   *
   * @param a accelerations of the state from {@code aAt}, rad/s² or m/s²; not modified
   * @param residual one number per extended velocity, N·m or N; overwritten; entries of driven
   *     velocities are the driving forces
   */
  public void formResidual(double[] wrench, double[] tau, double[] a, int aAt, double[] residual) {
    motion.accelerationSweep(a, aAt);
    if (rods.isEmpty()) {
      newtonEuler.evaluate(wrench, tau, residual);
      return;
    }
    Arrays.fill(loads, 0);
    System.arraycopy(wrench, 0, loads, 0, wrench.length);
    rods.addForces(motion, loads);
    newtonEuler.evaluate(loads, tau, residual);
  }

  /**
   * Solves for the accelerations without external wrenches.
   *
   * @param a as for {@link #accelerations(double[], double[], double[], int)}, from its begin
   */
  public int accelerations(double[] tau, double[] a) {
    return accelerations(NONE, tau, a, 0);
  }

  /**
   * Solves for the accelerations.
   *
   * @param a in state order from {@code aAt}, rad/s² or m/s²; overwritten
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  public int accelerations(double[] wrench, double[] tau, double[] a, int aAt) {
    formMassMatrix();
    formBias(wrench, tau);
    int singular = factorMassMatrix();
    if (singular == ExplicitModel.REGULAR) {
      for (int i = 0; i < tree.stateVelocityCount; i++) {
        a[aAt + i] = 0 - bias[i];
      }
      mass.solve(a, aAt);
    }
    return singular;
  }
}
