package org.mechservice.solver.api.capability;

/**
 * A model whose equations depend on more than t and y: on the choice of independent coordinates, on
 * starting values of an iteration, on a contact that is closed. A run of such a model can be saved
 * and taken up again only if the model tells that state.
 */
public interface ModelState {
  /** Returns how many numbers the state is, the same for all of the model's life. */
  int stateLength();

  /**
   * Writes the state.
   *
   * @param state overwritten
   */
  void saveState(double[] state);

  /**
   * Takes the state up again.
   *
   * @param state as written by {@link #saveState}; not modified
   */
  void restoreState(double[] state);
}
