package org.mechservice.solver.api;

import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * A mechanism ready for simulation: its name, the layout of its state, and its initial state.
 *
 * <p>A model implements one further interface for each quantity that it can compute ({@link
 * ExplicitModel}, {@link Energies}, {@link BodyPoses}); it omits the interfaces that its scene does
 * not need. A model owns its workspace: one instance belongs to one run and one thread.
 *
 * <p>The state is y = [q; v; s]: positions and velocities in SI units, joints in the order of
 * {@link ModelDescription#joints()}, then the {@link ModelDescription#furtherStates()} in their own
 * units. Most models have no further states; where documentation says [q; v], further states
 * follow.
 */
public interface Model {
  /** The version of this package; a model JAR names the version that it was compiled against. */
  int API_VERSION = 1;

  /** Returns names, units and default settings of the model. */
  ModelDescription description();

  /**
   * Writes the state at the start of the run.
   *
   * @param y state [q; v; s], length {@code description().stateCount()}; overwritten
   */
  void initialState(double[] y);

  /**
   * Returns whether classes of users compute some of its forces: nothing is known of these but
   * their values, so that a run searches for jumps in them.
   */
  default boolean hasUserClasses() {
    return false;
  }
}
