package org.mechservice.solver.api.capability;

/** A model with forces or motions that add or remove energy. */
public interface PowerInput {
  /**
   * Evaluates the power of all forces without potential energy: dampers, friction, prescribed
   * motions, forces given by expressions, user forces.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param power its sum, positive into the mechanism, at 0, and at 1 the sum of the absolute
   *     values of these powers, the energy flow through the mechanism even if the sum is small, W;
   *     overwritten
   */
  void power(double t, double[] y, double[] power);
}
