package org.mechservice.solver.api.run;

import java.io.IOException;
import java.util.Optional;

/**
 * A run that advances by steps of communication: from one output time to the next. Between two
 * steps the state may be changed, in particular the inputs of the model, which are constant within
 * a step; the integration then begins anew from there. Without a change it goes on as a run that
 * ends a step of the integrator at each row.
 *
 * <p>Belongs to one thread.
 */
public interface StepwiseRun {
  /**
   * Begins: writes the row of the start.
   *
   * @throws IOException if the sink throws it
   */
  void begin() throws IOException;

  /**
   * Returns the state from which the next step begins.
   *
   * @param y state [q; v; s], length of the model's state; overwritten
   */
  void state(double[] y);

  /**
   * Sets a component of the state from which the next step begins.
   *
   * @param component index in [q; v; s]
   */
  void set(int component, double value);

  /**
   * Takes over what was set: closes the loops with the components that were set held and the others
   * following them. Writes the row of the state, also if nothing was set; a step does not.
   *
   * @throws IllegalArgumentException S-195 if the loops do not close so; the state is that before
   *     anything was set, and the run can go on from there
   * @throws IllegalStateException if the run has ended
   * @throws IOException if the sink throws it
   */
  void settle() throws IOException;

  /**
   * Advances to the next output time and writes its row.
   *
   * @return whether the run goes on from there
   * @throws IllegalArgumentException as of {@link #settle}
   * @throws IllegalStateException if the run has ended
   * @throws IOException if the sink throws it
   */
  boolean step() throws IOException;

  /** Ends a step that another thread takes, and with it the run; without one, nothing happens. */
  void interrupt();

  /** Returns the time reached, s. */
  double time();

  /** Returns how the run has ended; empty if it goes on. */
  Optional<Outcome> ended();

  /** Returns the report so far; a run that goes on counts as stopped. */
  RunReport report();

  /**
   * Returns the run between two steps as bytes, with changes for the next step.
   *
   * @throws IllegalStateException if it has not begun or has failed
   */
  byte[] save();

  /**
   * Goes on with a saved run of the same model and settings, instead of {@link #begin} or from
   * wherever this one is; its rows are then the same to the bit.
   *
   * @throws IllegalArgumentException S-071 if the bytes do not belong to such a run
   */
  void restore(byte[] saved);
}
