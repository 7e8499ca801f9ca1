package org.mechservice.solver.analysis;

import java.util.Set;
import org.mechservice.solver.analysis.column.FurtherColumns;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;

/**
 * Superclass of the class of a model with further columns, which adds the data. The columns are
 * computed from the data, and so is the model unless code was generated for it.
 */
public abstract class ExtendedSource extends CompactSource {
  private final Set<ColumnGroup> groups;

  /**
   * @param groups labels of the columns' groups, separated by commas
   */
  protected ExtendedSource(String groups) {
    this.groups = ColumnGroup.of(groups);
    this.groups.remove(ColumnGroup.JOINTS);
  }

  /** Returns the data of model and columns; subclasses may hold motions constant. */
  CompactModel prepared(CompactModel data) {
    return data;
  }

  @Override
  protected Model made(CompactModel asBuilt) {
    CompactModel data = prepared(asBuilt);
    ModelParts built = ModelParts.of(super.made(data));
    return built.with(columns((ExplicitModel) built.equations(), data));
  }

  /**
   * Creates the columns. Outputs may be computed by another thread than the model, so they have
   * their own instance of the code.
   */
  private FurtherColumns columns(ExplicitModel model, CompactModel data) {
    return new FurtherColumns(model, data, groups, userForces(), values(data));
  }
}
