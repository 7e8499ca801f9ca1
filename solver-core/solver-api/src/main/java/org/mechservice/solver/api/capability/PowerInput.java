package org.mechservice.solver.api.capability;

/** A model with forces or motions that add or remove energy. */
public interface PowerInput {
  /**
   * Returns the power of all forces without potential energy: dampers, friction, prescribed
   * motions, forces given by expressions, user forces; W, positive into the mechanism.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   */
  double power(double t, double[] y);

  /**
   * Returns the sum of the absolute values of these powers, W: the energy flow through the
   * mechanism even if the sum of the powers is small.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   */
  default double turnover(double t, double[] y) {
    return Math.abs(power(t, y));
  }
}
