package org.mechservice.solver.simulation;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.run.RunSettings;

/**
 * How a model's equations are handed to an integrator. A JAR for one scene carries one form, so
 * what other scenes need stays out of it.
 */
public interface EquationForm {
  /**
   * Returns the equations of a model in this form.
   *
   * @throws IllegalArgumentException S-061 if the model does not have it
   */
  ModelEquations of(Model model);

  /**
   * Returns what happens along a run of a model.
   *
   * @param of its equations
   * @param settings of the run
   */
  default RunEvents events(Model model, ModelEquations of, RunSettings settings) {
    return new RunEvents();
  }
}
