package org.mechservice.solver.analysis;

import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;

/** Superclass of the class of a model whose motion is prescribed, which adds the data. */
public abstract class PrescribedSource extends ExtendedSource {
  /**
   * @param options none
   * @param groups labels of the columns' groups, separated by commas
   */
  protected PrescribedSource(String options, String groups) {
    super(groups);
  }

  @Override
  protected final Object bare(CompactModel data, UserForceSource userForces) {
    return new PrescribedModel(data, userForces);
  }
}
