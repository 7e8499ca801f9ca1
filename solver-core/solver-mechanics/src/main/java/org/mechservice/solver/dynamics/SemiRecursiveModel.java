package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/** DSR without generated code: an open tree by composite inertias. */
public final class SemiRecursiveModel extends OpenTreeModel {
  private final SemiRecursive dynamics;
  private final double[] residual;
  private final double[] solution;

  /**
   * @param mechanism an open tree
   * @param defaults default settings of the model
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  public SemiRecursiveModel(Mechanism mechanism, RunSettings defaults, UserForceSource userForces) {
    super(mechanism, Formulation.DSR.label(), defaults, userForces);
    dynamics = new SemiRecursive(motion);
    residual = new double[tree.velocityCount];
    solution = new double[tree.stateVelocityCount];
  }

  @Override
  int accelerate(double[] a, int aAt) {
    int singular = dynamics.accelerations(loads.wrench(), loads.tau(), a, aAt);
    System.arraycopy(a, aAt, solution, 0, solution.length);
    return singular;
  }

  @Override
  PivotCheck check() {
    return dynamics.check();
  }

  @Override
  void drivingForces(double[] force) {
    dynamics.formResidual(loads.wrench(), loads.tau(), solution, 0, residual);
    System.arraycopy(residual, tree.stateVelocityCount, force, 0, force.length);
  }
}
