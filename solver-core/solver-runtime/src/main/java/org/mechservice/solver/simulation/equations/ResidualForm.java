package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.LinearisedSystem;

/** F(t, y, y') = 0 of open chains and closed loops, for ode15sR. */
public final class ResidualForm implements EquationForm {
  @Override
  public ModelEquations of(Model model) {
    if (!(model instanceof ResidualModel residual)) {
      throw new IllegalArgumentException(
          MessageCode.EQUATION_FORM_MISSING
              + " model \""
              + model.description().name()
              + "\" has no residual form F(t, y, y') = 0");
    }
    if (model instanceof LinearisedModel linearised) {
      if (model instanceof ProjectedStates loops) {
        return new OnManifold(linearised, loops);
      }
      return model instanceof DependentStates loops
          ? new LinearisedInIndependentStates(linearised, loops)
          : new Linearised(linearised);
    }
    return model instanceof DependentStates loops
        ? new InIndependentStates(residual, loops)
        : new ResidualModelEquations(residual);
  }

  /** Loops closed by completing independent states. */
  private static final class InIndependentStates extends ResidualModelEquations
      implements LoopCompletion {
    private final DependentStates loops;

    InIndependentStates(ResidualModel model, DependentStates loops) {
      super(model);
      this.loops = loops;
    }

    @Override
    public DependentStates loops() {
      return loops;
    }
  }

  /** With the model's own linear algebra. */
  private static class Linearised extends ResidualModelEquations implements LinearisedSystem {
    private final LinearisedModel model;

    Linearised(LinearisedModel model) {
      super(model);
      this.model = model;
    }

    @Override
    public boolean linearise(double t, double[] y, double[] yDot) {
      return model.linearise(t, y, yDot);
    }

    @Override
    public boolean factor(double hGamma) {
      return model.factor(hGamma);
    }

    @Override
    public void solve(double[] r) {
      model.solve(r);
    }

    @Override
    public boolean solveForDerivative(double[] r) {
      return model.solveForDerivative(r);
    }

    @Override
    public int singularComponent() {
      return model.singularUnknown();
    }
  }

  /** With the model's own linear algebra, loops closed by completing independent states. */
  private static final class LinearisedInIndependentStates extends Linearised
      implements LoopCompletion {
    private final DependentStates loops;

    LinearisedInIndependentStates(LinearisedModel model, DependentStates loops) {
      super(model);
      this.loops = loops;
    }

    @Override
    public DependentStates loops() {
      return loops;
    }
  }

  /**
   * With the model's own linear algebra, loops among the equations. Residuals that the iteration
   * leaves would not decrease in the next step, so a projection removes them.
   */
  private static final class OnManifold extends Linearised implements ManifoldProjection {
    private final ProjectedStates loops;

    OnManifold(LinearisedModel model, ProjectedStates loops) {
      super(model);
      this.loops = loops;
    }

    @Override
    public ProjectedStates loops() {
      return loops;
    }
  }
}
