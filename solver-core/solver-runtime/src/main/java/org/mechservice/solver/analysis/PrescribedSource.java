package org.mechservice.solver.analysis;

import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;

/** What the class of a model all of whose motion is prescribed is, but for its data. */
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
