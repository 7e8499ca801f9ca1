package org.mechservice.solver.analysis;

import java.util.List;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;
import org.mechservice.solver.force.user.UserForceSource;

/** Superclass of the class of a model of small motions, which adds the data. */
public abstract class LinearSource extends CompactSource {
  private final boolean atEquilibrium;
  private final boolean modes;

  /**
   * @param options {@code start} or {@code equilibrium}, and {@code modes} or {@code matrices},
   *     separated by a blank
   * @param groups not used: a table has its own columns
   */
  protected LinearSource(String options, String groups) {
    List<String> words = List.of(options.split(" ", -1));
    atEquilibrium = words.contains("equilibrium");
    modes = words.contains("modes");
  }

  @Override
  protected final Object bare(CompactModel data, UserForceSource userForces) {
    return new LinearModel(data, atEquilibrium, modes, userForces);
  }
}
