package org.mechservice.report.method;

import java.util.function.Supplier;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;

/**
 * A method with the model built for it.
 *
 * @param method the method
 * @param models makes an instance for each run
 * @param solver runs it
 */
public record Candidate(SimulationMethod method, Supplier<Model> models, Solver solver) {
  /** Returns a new instance of the equations of motion, without events. */
  public ExplicitModel equations() {
    return (ExplicitModel) ModelParts.of(models.get()).equations();
  }

  /** Returns a new instance of the equations of motion with its events. */
  public ModelProblem problem() {
    ModelParts made = ModelParts.of(models.get());
    ExplicitModel equations = (ExplicitModel) made.equations();
    return made.events()
        .map(events -> new ModelProblem(equations, events))
        .orElseGet(() -> new ModelProblem(equations));
  }
}
