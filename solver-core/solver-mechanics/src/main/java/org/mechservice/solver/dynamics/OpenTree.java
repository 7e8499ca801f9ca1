package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The equations of the open tree, M(q) a + b(q, v) = τ + Jᵀ w, as those who close its loops need
 * them. Workspace of one thread.
 */
public interface OpenTree {
  /** Returns the motion these are the equations of; the caller sweeps it. */
  TreeMotion motion();

  /** Forms M for the places of the last sweep. */
  void formMassMatrix();

  /** Returns M, or its factors after {@link #factorMassMatrix}. */
  TreeMatrix massMatrix();

  /**
   * Overwrites M by its factors.
   *
   * @return {@link ExplicitModel#REGULAR}, or the velocity that no inertia resists
   */
  int factorMassMatrix();

  /** Returns how well M was conditioned when it was last factored. */
  PivotCheck check();

  /**
   * Forms b − τ − Jᵀ w for the last sweep; what driven joints add is in b. Sweeps the accelerations
   * of the motion with zero for all of the state.
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
   * @param residual one number per extended velocity, N·m or N; overwritten. Those of driven
   *     velocities are the forces that drive them
   */
  void formResidual(double[] wrench, double[] tau, double[] residual);
}
