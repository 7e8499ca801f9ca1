package org.mechservice.solver.compact;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * Superclass of the class of a model in compact form, which adds the data. An instance reads its
 * texts once, however many models it makes; may be used by several threads.
 */
public abstract class CompactSource implements ModelSource {
  private volatile Optional<CompactModel> read = Optional.empty();

  /** Returns the texts of {@link CompactModel#texts} that were written into the class. */
  protected abstract String[] texts();

  /** Returns the data. */
  protected final CompactModel data() {
    Optional<CompactModel> known = read;
    if (known.isEmpty()) {
      known = Optional.of(CompactModel.of(List.of(texts())));
      read = known;
    }
    return known.get();
  }

  /** Returns the source of user forces, which loads their classes with this class's loader. */
  protected final UserForceSource userForces() {
    return new LoadedUserForces(getClass().getClassLoader());
  }

  /**
   * Returns the model of some data, from generated code or by {@link DataDrivenTree} or {@link
   * DataDrivenLoops}, so that a JAR contains only what its model is evaluated by.
   */
  protected abstract Object bare(CompactModel data, UserForceSource userForces);

  /** Returns the generated code for the expressions of events and outputs, if any. */
  protected Optional<WrittenValues> values(CompactModel data) {
    return Optional.empty();
  }

  /** Returns the model of some data, complete. */
  protected Model made(CompactModel data) {
    return ModelSource.of(bare(data, userForces()));
  }

  @Override
  public final Model model() {
    return made(data());
  }

  @Override
  public List<TunableParameter> parameters() {
    return data().parameters();
  }

  @Override
  public final Model model(double[] values) {
    return made(data().with(values));
  }
}
