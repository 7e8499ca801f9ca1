package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The equations of the open tree, M(q) a + b(q, v) = τ + Jᵀ w, as loop closures use them. Workspace
 * of one thread.
 */
public interface OpenTree {
  /** Returns the motion of the tree; the caller sweeps it. */
  TreeMotion motion();

  /** Forms M for the poses of the last sweep. */
  void formMassMatrix();

  /** Returns M, or its factors after {@link #factorMassMatrix}. */
  TreeMatrix massMatrix();

  /**
   * Overwrites M by its factors.
   *
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  int factorMassMatrix();

  /** Returns the check of the pivots of the last factorisation of M. */
  PivotCheck check();

  /**
   * Forms b − τ − Jᵀ w for the last sweep; b includes the prescribed accelerations of driven
   * joints. Sweeps the accelerations of the motion, with zero for all states.
   *
   * @param wrench external wrenches [moment; force] in link axes at the reference points, 6 per
   *     link, N·m, N; empty for none; not modified
   * @param tau joint forces, one per extended velocity, N·m or N; not modified
   */
  void formBias(double[] wrench, double[] tau);

  /** Returns the b − τ − Jᵀ w formed last, one per extended velocity; not to be modified. */
  double[] bias();

  /**
   * Evaluates M a + b − τ − Jᵀ w by one sweep inwards, for the accelerations a of the motion's last
   * acceleration sweep; M need not be formed.
   *
   * @param wrench as for {@link #formBias}; not modified
   * @param tau as for {@link #formBias}; not modified
   * @param residual one number per extended velocity, N·m or N; overwritten; entries of driven
   *     velocities are the driving forces
   */
  void formResidual(double[] wrench, double[] tau, double[] residual);
}
