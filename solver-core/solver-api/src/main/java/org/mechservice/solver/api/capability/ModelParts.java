package org.mechservice.solver.api.capability;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;

/**
 * The parts of a model: its equations, its events, and its result columns beside joints, energies
 * and poses. {@link #of} returns the parts of any model; a model that consists of equations only
 * has no events and no columns.
 *
 * @param equations the equations, with the capabilities they implement
 * @param events the events; empty if the model has none
 * @param columns the further columns; {@link ResultColumns#NONE} if there are none
 */
public record ModelParts(Model equations, Optional<ModelEvents> events, ResultColumns columns)
    implements Model {
  /** Returns the parts of a model. */
  public static ModelParts of(Model model) {
    if (model instanceof ModelParts parts) {
      return parts;
    }
    ResultColumns own = model instanceof ResultColumns columns ? columns : ResultColumns.NONE;
    return new ModelParts(model, Optional.empty(), own);
  }

  /** Returns these parts with events. */
  public ModelParts with(ModelEvents along) {
    return new ModelParts(equations, Optional.of(along), columns);
  }

  /** Returns these parts with other columns. */
  public ModelParts with(ResultColumns further) {
    return new ModelParts(equations, events, further);
  }

  @Override
  public ModelDescription description() {
    return equations.description();
  }

  @Override
  public void initialState(double[] y) {
    equations.initialState(y);
  }

  @Override
  public boolean hasUserClasses() {
    return equations.hasUserClasses();
  }
}
