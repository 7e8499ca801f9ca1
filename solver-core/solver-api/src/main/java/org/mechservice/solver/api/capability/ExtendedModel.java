package org.mechservice.solver.api.capability;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.ResultColumns;

/**
 * A model with result columns that are computed apart from it.
 *
 * @param model the model
 * @param columns its columns
 */
public record ExtendedModel(Model model, ResultColumns columns) implements Model {
  @Override
  public ModelDescription description() {
    return model.description();
  }

  @Override
  public void initialState(double[] y) {
    model.initialState(y);
  }

  /** Returns a model without what extends it. */
  public static Model bare(Model model) {
    return model instanceof ExtendedModel extended ? extended.model() : model;
  }

  /** Returns the further columns of a model, of itself or apart from it. */
  public static ResultColumns columnsOf(Model model) {
    if (model instanceof ExtendedModel extended) {
      return extended.columns();
    }
    return WatchedModel.bare(model) instanceof ResultColumns own ? own : ResultColumns.NONE;
  }
}
