package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;

/**
 * The equations of models with events. It is separate from the other forms, so that a JAR for a
 * scene without events does not contain these classes.
 *
 * @param equations the form of the equations
 */
public record WatchedForm(EquationForm equations) implements EquationForm {
  @Override
  public ModelEquations of(Model model) {
    return equations.of(model);
  }

  @Override
  public RunEvents events(ModelParts model, ModelEquations of, RunSettings settings) {
    ModelEvents events =
        model
            .events()
            .orElseThrow(() -> new IllegalArgumentException("nothing happens to the model"));
    of.breakAt(events.begin(settings.tStart(), settings.tEnd()));
    if (events.watches()) {
      of.endStepsBehindChanges();
    }
    return events.kinds().isEmpty() && !events.watches()
        ? new RunEvents()
        : new WatchedRun(events, of, settings.relativeTolerance());
  }
}
