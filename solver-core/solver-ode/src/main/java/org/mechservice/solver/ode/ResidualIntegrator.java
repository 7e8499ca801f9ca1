package org.mechservice.solver.ode;

/** An integrator that takes problems in residual form, too. */
public interface ResidualIntegrator extends Integrator {
  /**
   * Begins a problem in residual form; whatever was begun before is forgotten.
   *
   * @param system the residual, and what it tells of itself by other interfaces
   * @param t0 start
   * @param y0 state at the start; its algebraic part is a guess; not modified
   * @param yDot0 guess of its derivative, that of passive components exact; not modified
   * @param tEnd end, on either side of the start or equal to it
   * @return {@link StepResult#ADVANCED}; {@link StepResult#REACHED_END} if {@code tEnd == t0};
   *     {@link StepResult#STOPPED} if told to stop, then to be begun anew; {@link
   *     StepResult#FAILED} if no consistent values were found
   * @throws IllegalArgumentException if something given is not finite, or if the lengths of state
   *     and derivative or the number of absolute tolerances do not fit the system
   */
  StepResult start(ResidualSystem system, double t0, double[] y0, double[] yDot0, double tEnd);

  /**
   * Goes on with an integration in residual form that was saved; see {@link
   * Integrator#resume(OdeSystem, byte[])}.
   */
  StepResult resume(ResidualSystem system, byte[] saved);
}
