package org.mechservice.solver.compact;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.force.user.UserForceSource;

/** What the class of a model in compact form is, but for its data. */
public abstract class CompactSource implements ModelSource {
  /** Returns what {@link CompactModel#texts} returned when the class was written. */
  protected abstract String[] texts();

  /** Returns the data. */
  protected final CompactModel data() {
    return CompactModel.of(List.of(texts()));
  }

  /** Returns what makes user forces of the classes beside this one. */
  protected final UserForceSource userForces() {
    return new LoadedUserForces(getClass().getClassLoader());
  }

  /** Returns the model of some data; a class beside generated code returns that. */
  protected Object bare(CompactModel data, UserForceSource userForces) {
    return data.model(userForces);
  }

  /** Returns code for the expressions of events and outputs, if some was generated. */
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
