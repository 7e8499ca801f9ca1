package org.mechservice.solver.analysis;

import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;

/** Superclass of the class of a model at rest, which adds the data. */
public abstract class EquilibriumSource extends ExtendedSource {
  private final double tolerance;
  private final int mostCorrections;

  /**
   * @param options largest residual force relative to the largest force, and largest number of
   *     corrections, separated by a blank
   * @param groups labels of the columns' groups, separated by commas
   */
  protected EquilibriumSource(String options, String groups) {
    super(groups);
    int blank = options.indexOf(' ');
    tolerance = Double.parseDouble(options.substring(0, blank));
    mostCorrections = Integer.parseInt(options.substring(blank + 1));
  }

  /** {@inheritDoc} Motions are held at their start values. */
  @Override
  final CompactModel prepared(CompactModel data) {
    return new CompactModel(
        HeldMotions.at(data.mechanism(), data.settings().tStart()),
        data.formulation(),
        data.closure(),
        data.settings(),
        data.outputs());
  }

  @Override
  protected final Object bare(CompactModel data, UserForceSource userForces) {
    return new EquilibriumModel(data, tolerance, mostCorrections, userForces);
  }
}
