package org.mechservice.solver.analysis;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;

/** Superclass of the class of a model at rest, which adds the data. */
public abstract class EquilibriumSource extends ExtendedSource {
  private final double tolerance;
  private final int mostCorrections;
  private final Optional<Trim> trim;

  /**
   * @param options largest residual force relative to the largest force, and largest number of
   *     corrections, separated by a blank, then the words of a trim problem, if one is asked for
   * @param groups labels of the columns' groups, separated by commas
   */
  protected EquilibriumSource(String options, String groups) {
    super(groups);
    List<String> words = List.of(options.split(" ", -1));
    tolerance = Double.parseDouble(words.get(0));
    mostCorrections = Integer.parseInt(words.get(1));
    trim =
        words.size() > 2 ? Optional.of(Trim.of(words.subList(2, words.size()))) : Optional.empty();
  }

  /** {@inheritDoc} Motions are held at their start values, unless a trim problem is solved. */
  @Override
  final CompactModel prepared(CompactModel data) {
    if (trim.isPresent()) {
      return data;
    }
    return new CompactModel(
        HeldMotions.at(data.mechanism(), data.settings().tStart()),
        data.formulation(),
        data.closure(),
        data.settings(),
        data.outputs());
  }

  @Override
  protected final Object bare(CompactModel data, UserForceSource userForces) {
    return new EquilibriumModel(data, tolerance, mostCorrections, trim, userForces);
  }
}
