package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.dynamics.recursion.TreeSteps;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * DTR without generated code: an open tree by the articulated-body algorithm. Generated classes are
 * tested against it.
 */
public final class DataDrivenModel extends OpenTreeModel {
  private final TreeSteps steps;

  /**
   * @param mechanism an open tree without user forces
   * @param defaults default settings of the model
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  public DataDrivenModel(Mechanism mechanism, RunSettings defaults) {
    this(mechanism, defaults, UserForceSource.NONE);
  }

  /**
   * @param mechanism an open tree
   * @param defaults default settings of the model
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  public DataDrivenModel(Mechanism mechanism, RunSettings defaults, UserForceSource userForces) {
    super(mechanism, Formulation.DTR.label(), defaults, userForces);
    steps = new TreeSteps(motion);
  }

  @Override
  void place(double t, double[] y) {
    motion.setCoordinates(t, y);
  }

  @Override
  int accelerate(double[] a, int aAt) {
    return steps.accelerations(loads.wrench(), loads.tau(), a, aAt);
  }

  @Override
  PivotCheck check() {
    return steps.check();
  }

  @Override
  void drivingForces(double[] force) {
    System.arraycopy(steps.drivingForces(), 0, force, 0, force.length);
  }
}
