package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;

/**
 * How a model's equations are handed to an integrator. A JAR for one scene carries one form, so
 * what other scenes need stays out of it.
 */
public interface EquationForm {
  /**
   * Returns the equations in this form.
   *
   * @param equations those of a model, without its events
   * @throws IllegalArgumentException S-061 if they do not have it
   */
  ModelEquations of(Model equations);

  /**
   * Returns what happens along a run of a model.
   *
   * @param of its equations
   * @param settings of the run
   */
  default RunEvents events(ModelParts model, ModelEquations of, RunSettings settings) {
    return new RunEvents();
  }
}
