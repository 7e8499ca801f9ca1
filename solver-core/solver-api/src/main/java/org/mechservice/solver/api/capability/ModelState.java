package org.mechservice.solver.api.capability;

/**
 * A model whose equations depend on an internal state besides t and y: the choice of independent
 * coordinates, starting values of an iteration, a closed contact. A run of such a model can be
 * saved and resumed only through this interface.
 */
public interface ModelState {
  /** Returns the length of the state, which is constant for a model. */
  int stateLength();

  /**
   * Writes the state.
   *
   * @param state overwritten
   */
  void saveState(double[] state);

  /**
   * Restores the state.
   *
   * @param state as written by {@link #saveState}; not modified
   */
  void restoreState(double[] state);
}
