package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.LinkJacobian;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.dynamics.derivative.StepReduction;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.derivative.TreeStep;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * RR-JF without generated code: the recursive residual of an open tree with its Jacobian, and the
 * equations of an implicit step solved along the tree.
 */
public final class LinearisedResidualModel extends RecursiveResidualModel
    implements LinearisedModel {
  /** Contributions to the Jacobian besides M. */
  public enum Mode {
    /** All contributions. */
    FULL,
    /**
     * Applied forces only. This is cheaper and sufficient if the forces make the problem stiff; the
     * iteration makes up for the omitted inertia terms.
     */
    FORCES_ONLY
  }

  private final Mode mode;
  private final StepDerivatives derivatives;
  private final FurtherDerivatives furtherDerivatives;
  private final TreeStep step;

  /**
   * @param mechanism an open tree
   * @param defaults default settings of the model
   * @param userForces creates the user forces
   * @param mode contributions to the Jacobian
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  public LinearisedResidualModel(
      Mechanism mechanism, RunSettings defaults, UserForceSource userForces, Mode mode) {
    super(mechanism, Formulation.RR_JF.label(), defaults, userForces);
    this.mode = mode;
    boolean local = loads.forces().isLocal();
    boolean pays =
        local ? ArticulatedIteration.pays(tree) : ArticulatedIteration.paysFarCouplings(tree);
    StepReduction iteration;
    if (mode == Mode.FULL && pays) {
      LinkJacobian byLinks =
          local ? new LinkJacobian(motion) : new LinkJacobian(motion, coupledLinks(loads.forces()));
      derivatives = byLinks;
      iteration = new ArticulatedIteration(byLinks);
    } else {
      TreePattern pattern = new TreePattern(tree, coupledLinks(loads.forces()));
      ResidualJacobian byElements = new ResidualJacobian(motion, pattern);
      derivatives = byElements;
      iteration = new TreeIteration(tree, pattern, byElements);
    }
    furtherDerivatives =
        new FurtherDerivatives(tree.statePositionCount, tree.stateVelocityCount, further.count());
    step = new TreeStep(iteration, furtherDerivatives);
  }

  /** Returns the pairs of links that forces couple, two numbers each. */
  static int[] coupledLinks(ForceSet forces) {
    List<Integer> links = new ArrayList<>();
    forces.couplings(
        (on, by) -> {
          links.add(on);
          links.add(by);
        });
    return links.stream().mapToInt(Integer::intValue).toArray();
  }

  @Override
  public boolean linearise(double t, double[] y, double[] yDot) {
    if (load(t, y) != REGULAR) {
      return false;
    }
    motion.sweepRelative();
    motion.accelerationSweep(yDot, tree.statePositionCount);
    if (mode == Mode.FORCES_ONLY && derivatives instanceof ResidualJacobian elements) {
      elements.evaluateMass();
    } else {
      derivatives.evaluate(loads.wrench());
    }
    if (loads.forces().linearise(t, derivatives.forces()) != ForceSet.REGULAR) {
      fail(loads.forces().defect());
      return false;
    }
    derivatives.finish();
    step.setState(y);
    furtherDerivatives.evaluate(motion, loads.forces(), further, coordinates, t, y);
    return derivatives.isFinite() && furtherDerivatives.isFinite();
  }

  @Override
  public boolean factor(double hGamma) {
    return step.factor(hGamma);
  }

  @Override
  public void solve(double[] r) {
    step.solve(r);
  }

  @Override
  public boolean solveForDerivative(double[] r) {
    return step.solveForDerivative(r);
  }

  @Override
  public int singularUnknown() {
    return step.singularUnknown();
  }

  @Override
  public List<Note> notes() {
    List<Note> notes = new ArrayList<>(super.notes());
    notes.addAll(step.notes());
    return notes;
  }
}
