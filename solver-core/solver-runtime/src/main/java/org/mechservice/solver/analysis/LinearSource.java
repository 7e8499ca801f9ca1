package org.mechservice.solver.analysis;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;
import org.mechservice.solver.force.user.UserForceSource;

/** Superclass of the class of a model of small motions, which adds the data. */
public abstract class LinearSource extends CompactSource {
  private final boolean atEquilibrium;
  private final Optional<Trim> trim;
  private final LinearResult result;

  /**
   * @param options {@code start}, {@code equilibrium} or {@code trim}, what is asked for, and the
   *     frequencies of a response: {@code start response 0.1 100 200}; then the words of a trim
   *     problem
   * @param groups not used: a table has its own columns
   */
  protected LinearSource(String options, String groups) {
    List<String> words = List.of(options.split(" ", -1));
    atEquilibrium = words.get(0).equals("equilibrium");
    result = LinearResult.of(words.subList(1, words.size()));
    int before = 2 + result.frequencies();
    trim =
        words.get(0).equals("trim")
            ? Optional.of(Trim.of(words.subList(before, words.size())))
            : Optional.empty();
  }

  @Override
  protected final Object bare(CompactModel data, UserForceSource userForces) {
    return new LinearModel(data, atEquilibrium, trim, result, userForces);
  }
}
