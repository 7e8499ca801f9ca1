package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.dynamics.recursion.TreeSteps;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * RR without generated code: the residual F = [q' − N(q) v; M(q) v' + b(q, v) − τ] of an open tree,
 * by one Newton-Euler sweep out and one in. Accelerations at the start and in outputs come from
 * articulated bodies.
 */
public class RecursiveResidualModel extends OpenTreeModel implements ResidualModel {
  private final TreeSteps steps;
  private final double[] extended;

  /**
   * @param mechanism an open tree
   * @param defaults default settings of the model
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  public RecursiveResidualModel(
      Mechanism mechanism, RunSettings defaults, UserForceSource userForces) {
    this(mechanism, Formulation.RR.label(), defaults, userForces);
  }

  RecursiveResidualModel(
      Mechanism mechanism, String formulation, RunSettings defaults, UserForceSource userForces) {
    super(mechanism, formulation, defaults, userForces);
    steps = new TreeSteps(motion);
    extended = new double[tree.velocityCount];
  }

  @Override
  final void place(double t, double[] y) {
    motion.setCoordinates(t, y);
  }

  @Override
  final int accelerate(double[] a, int aAt) {
    return steps.accelerations(loads.wrench(), loads.tau(), a, aAt);
  }

  @Override
  final PivotCheck check() {
    return steps.check();
  }

  @Override
  final void drivingForces(double[] force) {
    System.arraycopy(steps.drivingForces(), 0, force, 0, force.length);
  }

  @Override
  public final int residual(double t, double[] y, double[] yDot, double[] residual) {
    int nq = tree.statePositionCount;
    int loaded = load(t, y);
    if (loaded != REGULAR) {
      return loaded;
    }
    coordinates.rates(y, 0, y, nq, residual, 0);
    for (int i = 0; i < nq; i++) {
      residual[i] = yDot[i] - residual[i];
    }
    steps.forces(loads.wrench(), loads.tau(), yDot, nq, extended);
    System.arraycopy(extended, 0, residual, nq, tree.stateVelocityCount);
    int at = nq + tree.stateVelocityCount;
    further.evaluate(t, residual, at);
    for (int i = at; i < at + further.count(); i++) {
      residual[i] = yDot[i] - residual[i];
    }
    return REGULAR;
  }
}
