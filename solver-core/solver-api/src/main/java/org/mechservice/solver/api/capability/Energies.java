package org.mechservice.solver.api.capability;

/** A model that computes its mechanical energy. */
public interface Energies {
  /**
   * Evaluates kinetic and potential energy.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param energy kinetic energy at 0, potential energy at 1, J; overwritten
   */
  void energy(double t, double[] y, double[] energy);
}
