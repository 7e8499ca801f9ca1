package org.mechservice.solver.analysis;

import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;

/**
 * What the class of a model with further columns is, but for its data: they serve the columns, and
 * the model too unless code was generated for it.
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

  /** Returns the data that model and columns are about; where motions are held, so held. */
  CompactModel prepared(CompactModel data) {
    return data;
  }

  @Override
  protected Model made(CompactModel asBuilt) {
    CompactModel data = prepared(asBuilt);
    ModelParts built = ModelParts.of(super.made(data));
    return built.with(columns((ExplicitModel) built.equations(), data));
  }

  /** Outputs are computed beside the model, perhaps by another thread: their code is its own. */
  private FurtherColumns columns(ExplicitModel model, CompactModel data) {
    return new FurtherColumns(model, data, groups, userForces(), values(data));
  }
}
