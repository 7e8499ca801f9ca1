package org.mechservice.solver.dynamics;

import java.util.Optional;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.recursion.ArticulatedBody;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * RR without generated code: the residual F = [q' − N(q) v; M(q) v' + b(q, v) − τ] of an open tree,
 * by one Newton-Euler sweep out and one in. Accelerations at the start and in outputs come from
 * composite inertias; those of long chains, whose mass matrix is dense, from articulated bodies.
 */
public class RecursiveResidualModel extends OpenTreeModel implements ResidualModel {
  private final NewtonEuler newtonEuler;
  private final ArticulatedBody bodies;
  private final ArticulatedBody.Workspace articulated;
  private final Optional<Composites> composites;
  private final double[] solution;
  private final double[] extended;

  private record Composites(SemiRecursive dynamics, SemiRecursive.Workspace workspace) {}

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
    newtonEuler = new NewtonEuler(motion, new LinkInertias(tree));
    bodies = new ArticulatedBody(tree);
    articulated = bodies.newWorkspace(motion);
    if (ArticulatedIteration.pays(tree)) {
      composites = Optional.empty();
    } else {
      SemiRecursive dynamics = new SemiRecursive(tree);
      composites = Optional.of(new Composites(dynamics, dynamics.newWorkspace(motion)));
    }
    solution = new double[tree.stateVelocityCount];
    extended = new double[tree.velocityCount];
  }

  @Override
  final int accelerate(double[] a, int aAt) {
    if (composites.isEmpty()) {
      return bodies.accelerations(articulated, loads.wrench(), loads.tau(), a, aAt);
    }
    Composites composed = composites.get();
    int singular =
        composed.dynamics.accelerations(composed.workspace, loads.wrench(), loads.tau(), a, aAt);
    System.arraycopy(a, aAt, solution, 0, solution.length);
    return singular;
  }

  @Override
  final PivotCheck check() {
    return composites.isPresent() ? composites.get().workspace.check() : articulated.check();
  }

  @Override
  final void drivingForces(double[] force) {
    if (composites.isEmpty()) {
      System.arraycopy(articulated.drivingForces(), 0, force, 0, force.length);
      return;
    }
    motion.accelerationSweep(solution);
    newtonEuler.evaluate(loads.wrench(), loads.tau(), extended);
    System.arraycopy(extended, tree.stateVelocityCount, force, 0, force.length);
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
    motion.accelerationSweep(yDot, nq);
    newtonEuler.evaluate(loads.wrench(), loads.tau(), extended);
    System.arraycopy(extended, 0, residual, nq, tree.stateVelocityCount);
    int at = nq + tree.stateVelocityCount;
    further.evaluate(t, residual, at);
    for (int i = at; i < at + further.count(); i++) {
      residual[i] = yDot[i] - residual[i];
    }
    return REGULAR;
  }
}
