package org.mechservice.solver.api.capability;

/** A model with forces or motions that put energy in or take it out. */
public interface PowerInput {
  /**
   * Returns the power of everything that has no potential energy: dampers, friction, prescribed
   * motions, forces given by expressions or classes; W, positive into the mechanism.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   */
  double power(double t, double[] y);

  /**
   * Returns the sum of the sizes of the same powers, each taken by itself, W: what flows through
   * the mechanism where the sum of the powers is small.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   */
  default double turnover(double t, double[] y) {
    return Math.abs(power(t, y));
  }

  /**
   * Returns whether {@link #power} leaves nothing out. It does where loops contain motions that are
   * prescribed in time: their forces are multipliers, which no state tells.
   */
  default boolean holdsAllPower() {
    return true;
  }
}
