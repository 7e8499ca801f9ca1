package org.mechservice.solver.api;

import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * A mechanism ready to be simulated: what it is called, how its state is laid out, where it starts.
 *
 * <p>What a model can compute is told by the further interfaces it implements ({@link
 * ExplicitModel}, {@link Energies}, {@link BodyPoses}), so what a scene does not need is absent and
 * can be asked for. A model owns its workspace: one instance belongs to one run and one thread.
 *
 * <p>The state is y = [q; v] in SI units, joints in the order of {@link ModelDescription#joints()}.
 */
public interface Model {
  /** The version of this package; a model JAR names the one it was compiled against. */
  int API_VERSION = 1;

  /** Returns names, units and the settings the model was built with. */
  ModelDescription description();

  /**
   * Writes the state at the start of the run.
   *
   * @param y state [q; v], length {@code description().stateCount()}; overwritten
   */
  void initialState(double[] y);
}
