package org.mechservice.solver.api.capability;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;

/**
 * A model along whose runs something happens.
 *
 * @param model the model
 * @param events what happens
 */
public record WatchedModel(Model model, ModelEvents events) implements Model {
  @Override
  public ModelDescription description() {
    return model.description();
  }

  @Override
  public void initialState(double[] y) {
    model.initialState(y);
  }

  /** Returns a model without its events. */
  public static Model bare(Model model) {
    return model instanceof WatchedModel watched ? watched.model() : model;
  }

  /** Returns the events of a model, if it has any. */
  public static Optional<ModelEvents> eventsOf(Model model) {
    return model instanceof WatchedModel watched ? Optional.of(watched.events()) : Optional.empty();
  }
}
