package org.mechservice.solver.analysis;

import java.util.Set;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.ExtendedModel;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.WatchedModel;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;
import org.mechservice.solver.force.UserForceSource;

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

  /** Returns the model without further columns; a class that holds generated code returns that. */
  protected Object bare(CompactModel data, UserForceSource userForces) {
    return data.model(userForces);
  }

  @Override
  public Model model() {
    return extended(data());
  }

  @Override
  public Model model(double[] values) {
    return extended(data().with(values));
  }

  private Model extended(CompactModel asBuilt) {
    CompactModel data = prepared(asBuilt);
    UserForceSource userForces = userForces();
    Model built = ModelSource.of(bare(data, userForces));
    ExplicitModel model = (ExplicitModel) WatchedModel.bare(built);
    return new ExtendedModel(built, new FurtherColumns(model, data, groups, userForces));
  }
}
