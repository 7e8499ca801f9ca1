package org.mechservice.solver.force.applied;

/** A force between two bodies as a function of their relative motion, see {@link FrameMotion}. */
public interface FrameLaw {
  /**
   * Sets the coefficients.
   *
   * @param force receives the defect of an unusable coefficient
   * @return false if they cannot be used
   */
  boolean parameters(double[] values, AppliedForce force);

  /**
   * Evaluates the law.
   *
   * @param x relative motion; not modified
   * @param w [moment; force] on body 2 at the origin of frame 2, in the axes of frame 1;
   *     overwritten
   * @return false if there is none; the force has received the defect
   */
  boolean wrench(FrameMotion x, double[] w, AppliedForce force);

  /**
   * Differentiates the law at the state of the last {@link #wrench}.
   *
   * @param by derivative by [rotation; displacement] of frame 2 with its twist held, 6 × 6 row by
   *     row, then by its twist, likewise; zero at entry, overwritten
   */
  void slopes(FrameMotion x, double[] by);

  /**
   * Differentiates the law by a further state, at the state of the last {@link #wrench}. Most laws
   * do not depend on further states.
   *
   * @param w derivative of [moment; force] as in {@link #wrench}; overwritten
   * @return false if it is zero; {@code w} is not written then
   */
  default boolean byState(int state, double[] w) {
    return false;
  }

  /** Returns the potential energy in the state of the last {@link #wrench}, J. */
  double potentialEnergy();

  /**
   * Returns the power of the part without potential energy along its twist, W.
   *
   * @param w the wrench of the last {@link #wrench}; not modified
   */
  double power(FrameMotion x, double[] w);

  /** Writes the values of the last {@link #wrench}. */
  void values(FrameMotion x, double[] out, int at);

  /** Stores the unwrapped angle after an accepted step. */
  default void accepted() {}
}
