package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.derivative.TreeStep;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A generated residual with its derivatives (RR-JF) combined with user force classes. The generated
 * derivatives hold the forces' wrenches constant in the axes of their links; this class adds the
 * derivatives of the forces themselves, their own or by differences. The couplings of user forces
 * are known only at run time, so the equations of a step have their own sparsity pattern.
 */
final class UserForcedStepModel extends UserForcedResidualModel
    implements LinearisedModel, RunNotes {
  private final TreeStepModel generated;
  private final ResidualJacobian jacobian;
  private final TreeStep step;

  /** Index of each element of the generated pattern in the pattern of this model. */
  private final int[] elementAt;

  UserForcedStepModel(TreeStepModel generated, Mechanism mechanism, UserLoads loads) {
    super(generated, mechanism, loads);
    this.generated = generated;
    TreePattern inner = generated.byVelocity.pattern;
    TreePattern coupled =
        new TreePattern(
            loads.motion().tree(), LinearisedResidualModel.coupledLinks(loads.forces()));
    TreePattern pattern = inner.joined(coupled);
    elementAt = new int[inner.elementCount()];
    for (int row = 0; row < inner.size; row++) {
      for (int e = inner.rowStart[row]; e < inner.rowStart[row + 1]; e++) {
        elementAt[e] = pattern.find(row, inner.column[e]);
      }
    }
    jacobian = new ResidualJacobian(loads.motion(), pattern);
    step =
        new TreeStep(
            new TreeIteration(loads.motion().tree(), pattern, jacobian), generated.further());
  }

  @Override
  public boolean linearise(double t, double[] y, double[] yDot) {
    if (loads.evaluate(t, y) != REGULAR
        || !generated.linearise(t, y, yDot)
        || !loads.linearise(t, jacobian)) {
      return false;
    }
    add(generated.mass.diagonal(), jacobian.mass().diagonal());
    addElements(generated.mass.lower(), jacobian.mass().lower());
    add(generated.byVelocity, jacobian.byVelocity());
    add(generated.byPosition, jacobian.byPosition());
    step.setState(y);
    return jacobian.isFinite();
  }

  private void add(TreeSquare from, TreeSquare to) {
    add(from.diagonal, to.diagonal);
    addElements(from.lower, to.lower);
    addElements(from.upper, to.upper);
  }

  private static void add(double[] from, double[] to) {
    for (int i = 0; i < from.length; i++) {
      to[i] += from[i];
    }
  }

  private void addElements(double[] from, double[] to) {
    for (int e = 0; e < from.length; e++) {
      to[elementAt[e]] += from[e];
    }
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
    List<Note> notes = new ArrayList<>(generated.notes());
    notes.addAll(step.notes());
    return notes;
  }
}
