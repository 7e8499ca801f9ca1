package org.mechservice.solver.ode;

import java.util.List;

/**
 * Advances an initial value problem by steps of its own choice; whatever lies inside the last step
 * can be interpolated.
 *
 * <pre>{@code
 * integrator.start(system, t0, y0, tEnd);
 * while (integrator.step() == StepResult.ADVANCED) {
 *   for (; next <= integrator.time(); next += h) integrator.interpolate(next, y, yDot);
 * }
 * }</pre>
 *
 * <p>An integrator is a workspace for one problem at a time and one thread. After {@link #start}
 * nothing allocates memory.
 */
public interface Integrator {
  /**
   * A place at which one method took over from another.
   *
   * @param time where
   * @param stiff whether the method for stiff problems took over: stability had limited the steps
   *     of the other; else an explicit step would have cost no more
   * @param stepSize of the last step before, signed
   */
  record MethodChange(double time, boolean stiff, double stepSize) {}

  /**
   * Begins a problem; evaluates f once. Whatever was begun before is forgotten.
   *
   * @param system the right-hand side
   * @param t0 start
   * @param y0 state at the start, length {@code system.dimension()}; not modified
   * @param tEnd end, on either side of the start or equal to it
   * @return {@link StepResult#ADVANCED}, {@link StepResult#REACHED_END} if {@code tEnd == t0}, or
   *     {@link StepResult#FAILED} if f is not finite at the start
   * @throws IllegalArgumentException if start, end or initial state is not finite, or if the length
   *     of the initial state or the number of absolute tolerances does not fit the system
   */
  StepResult start(OdeSystem system, double t0, double[] y0, double tEnd);

  /**
   * Goes on from another state, or with equations that have changed, at a place inside or at the
   * end of the last step: the history is forgotten, the order is 1, the step that of a start. The
   * counters go on. Evaluates f once.
   *
   * @param t between {@link #previousTime()} and {@link #time()}, both included
   * @param y state there; not modified
   * @return {@link StepResult#ADVANCED}, {@link StepResult#REACHED_END} if that is the end, {@link
   *     StepResult#FAILED} if f is not finite there, or {@link StepResult#STOPPED} if told to stop
   *     before consistent values of a problem in residual form were found: then to be called again
   * @throws IllegalArgumentException if {@code t} lies outside the last step, or if the state is
   *     not finite or of the wrong length
   */
  default StepResult restart(double t, double[] y) {
    return restart(t, y, Double.POSITIVE_INFINITY);
  }

  /**
   * Goes on as {@link #restart(double, double[])} does, with a bound for the first step.
   *
   * @param longestFirstStep positive
   */
  StepResult restart(double t, double[] y, double longestFirstStep);

  /**
   * Takes one accepted step, trying smaller ones and other orders as the error test asks.
   *
   * @return {@link StepResult#ADVANCED} while the end is not reached, {@link
   *     StepResult#REACHED_END} when the end lies inside or at the end of this step, else {@link
   *     StepResult#FAILED} or {@link StepResult#STOPPED}, with the state unchanged. After {@code
   *     STOPPED} the next call takes the step up again, with the same results as if it had not been
   *     stopped.
   * @throws IllegalStateException if there is nothing to integrate: before the start, at the end,
   *     or after a failure
   */
  StepResult step();

  /**
   * Returns the end of the last accepted step, or the end of the problem where DE has stepped past
   * it.
   */
  double time();

  /** Returns the start of the last accepted step. */
  double previousTime();

  /** Returns the size of the last accepted step, signed; 0 before the first. */
  double stepSize();

  /** Returns the order used in the last accepted step; 0 before the first. */
  int order();

  /**
   * Evaluates state and derivative inside the last accepted step, to the order of the method. The
   * integration is not affected.
   *
   * @param t between {@link #previousTime()} and {@link #time()}, both included
   * @param y state at {@code t}; overwritten
   * @param yDot derivative of the interpolating polynomial at {@code t}; overwritten
   * @throws IllegalArgumentException if {@code t} lies outside the last step
   */
  void interpolate(double t, double[] y, double[] yDot);

  /** Returns how many numbers {@link #keepStep} keeps of the last accepted step. */
  int keptLength();

  /**
   * Keeps what describes the solution inside the last accepted step, so that it can be evaluated
   * when the integration has gone on: some k + 2 vectors of length n with a method of order k.
   *
   * @param kept written to from the given place on, {@link #keptLength} numbers
   * @return evaluates the solution from these numbers
   * @throws IllegalStateException if there is no such step: before the first one and just after a
   *     restart
   */
  StepPolynomial keepStep(double[] kept, int from);

  /**
   * Returns the integration between two steps, its whole history, as bytes; {@link #resume} goes on
   * from them with the same bits. A problem with a state of its own is to be a {@link SavedSystem}.
   *
   * @throws IllegalStateException if there is nothing to go on from: before the start, after a
   *     failure, or within a step that was stopped
   */
  byte[] save();

  /**
   * Goes on with an integration saved by an integrator of the same kind and settings; whatever was
   * begun before is forgotten. The last step can be interpolated as before.
   *
   * @param system the same problem
   * @return {@link StepResult#ADVANCED}, or {@link StepResult#REACHED_END} if the end was reached
   * @throws IllegalArgumentException if the bytes are damaged, of another format, method, settings,
   *     or number of unknowns; the message says which
   */
  StepResult resume(OdeSystem system, byte[] saved);

  /** Returns what the integrator has done since {@link #start}. */
  IntegrationStatistics statistics();

  /**
   * Returns where one method took over from another since {@link #start}, the first sixteen places;
   * empty for a method that stays what it is.
   */
  default List<MethodChange> methodChanges() {
    return List.of();
  }

  /** Returns how many such places there were. */
  default long methodChangeCount() {
    return 0;
  }

  /**
   * Returns why the last call gave {@link StepResult#FAILED}.
   *
   * @throws IllegalStateException if it did not fail
   */
  IntegrationFailure failure();
}
