package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;

/**
 * A form of a model's equations for an integrator. A JAR for one scene contains only the form that
 * the scene needs.
 */
public interface EquationForm {
  /**
   * Returns the equations in this form.
   *
   * @param equations equations of a model, without its events
   * @throws IllegalArgumentException S-061 if they do not have it
   */
  ModelEquations of(Model equations);

  /**
   * Returns the events of a run of a model.
   *
   * @param of its equations
   * @param settings settings of the run
   */
  default RunEvents events(ModelParts model, ModelEquations of, RunSettings settings) {
    return new RunEvents();
  }
}
