package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ProjectedStates;

/** y' = f(t, y) of mechanisms with closed loops. */
public final class ExplicitLoopForm implements EquationForm {
  @Override
  public ModelEquations of(Model model) {
    ExplicitModel explicit = ExplicitForm.explicit(model);
    if (model instanceof DependentStates loops) {
      return new InIndependentStates(explicit, loops);
    }
    return model instanceof ProjectedStates loops
        ? new OnManifold(explicit, loops)
        : new ExplicitModelEquations(explicit);
  }

  /** Loops closed by completing independent states. */
  private static final class InIndependentStates extends ExplicitModelEquations
      implements LoopCompletion {
    private final DependentStates loops;

    InIndependentStates(ExplicitModel model, DependentStates loops) {
      super(model);
      this.loops = loops;
    }

    @Override
    public DependentStates loops() {
      return loops;
    }
  }

  /** Loops kept closed by projection. */
  private static final class OnManifold extends ExplicitModelEquations
      implements ManifoldProjection {
    private final ProjectedStates loops;

    OnManifold(ExplicitModel model, ProjectedStates loops) {
      super(model);
      this.loops = loops;
    }

    @Override
    public ProjectedStates loops() {
      return loops;
    }
  }
}
