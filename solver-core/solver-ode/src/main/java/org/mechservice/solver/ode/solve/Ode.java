package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.OdeSystem;

/**
 * Integrates initial value problems y' = f(t, y), y(t0) = y0, and M y' = f(t, y), in one call:
 *
 * <pre>{@code
 * OdeSolution decay = Ode.solve((t, y, yDot) -> yDot[0] = -y[0], 0, new double[] {1}, 5);
 * double half = decay.at(0.5)[0];
 * }</pre>
 *
 * <p>The end may lie before the start: the integration then runs backwards. What is known of f
 * beside its values is added to a problem made by {@link #system(int, OdeFunction)}.
 */
public final class Ode {
  private Ode() {}

  /** Returns a problem with n unknowns, to which parts can be added. */
  public static OdeProblem system(int dimension, OdeFunction function) {
    return new OdeProblem(dimension, function, PartsOfProblem.NONE);
  }

  /** Returns a system with all its parts as a problem to which others can be added. */
  public static OdeProblem system(OdeSystem system) {
    return new OdeProblem(system.dimension(), system::derivative, PartsOfProblem.of(system));
  }

  /**
   * Integrates y' = f(t, y) with the {@linkplain OdeOptions#standard standard options}.
   *
   * @param y0 state at the start; not modified
   * @throws IntegrationException if the end cannot be reached
   * @throws IllegalArgumentException if start, end or initial state is not finite
   */
  public static OdeSolution solve(OdeFunction function, double t0, double[] y0, double t1) {
    return solve(function, t0, y0, t1, OdeOptions.standard());
  }

  /**
   * Integrates y' = f(t, y).
   *
   * @param y0 state at the start; not modified
   * @throws IntegrationException if the end cannot be reached and {@link OdeOptions#returnFailures}
   *     was not asked for
   * @throws IllegalArgumentException if start, end or initial state is not finite, or if the
   *     options do not fit the problem
   */
  public static OdeSolution solve(
      OdeFunction function, double t0, double[] y0, double t1, OdeOptions options) {
    return solve(system(y0.length, function), t0, y0, t1, options);
  }

  /** Integrates y' = f(t, y) with the standard options. */
  public static OdeSolution solve(OdeSystem system, double t0, double[] y0, double t1) {
    return solve(system, t0, y0, t1, OdeOptions.standard());
  }

  /**
   * Integrates y' = f(t, y) with all that the system tells of itself.
   *
   * @param y0 state at the start; not modified
   * @throws IntegrationException if the end cannot be reached and {@link OdeOptions#returnFailures}
   *     was not asked for
   * @throws IllegalArgumentException if start, end or initial state is not finite, or if state or
   *     options do not fit the problem
   */
  public static OdeSolution solve(
      OdeSystem system, double t0, double[] y0, double t1, OdeOptions options) {
    return new IntegrationRun(posed(system, options), options).solve(t0, y0, t1);
  }

  /** Integrates M y' = f(t, y) with the standard options. */
  public static OdeSolution solve(MassProblem problem, double t0, double[] y0, double t1) {
    return solve(problem, t0, y0, t1, OdeOptions.standard());
  }

  /**
   * Integrates M y' = f(t, y).
   *
   * @param y0 state at the start, its algebraic part a guess; not modified
   * @throws IntegrationException if the end cannot be reached and {@link OdeOptions#returnFailures}
   *     was not asked for
   * @throws IllegalArgumentException also if M is singular and the method cannot take it
   */
  public static OdeSolution solve(
      MassProblem problem, double t0, double[] y0, double t1, OdeOptions options) {
    OdeSolution.requireLength("y0", y0, problem.dimension());
    double[] slope = problem.slope(t0, y0);
    return new IntegrationRun(posed(problem, slope, options), options).solve(t0, y0, t1);
  }

  /**
   * Goes on with an integration of the same problem and options from a checkpoint; the solution
   * begins there.
   *
   * @throws IllegalArgumentException if the bytes are damaged or belong to another problem, method
   *     or tolerance
   */
  public static OdeSolution resume(OdeSystem system, OdeCheckpoint checkpoint, OdeOptions options) {
    return new IntegrationRun(posed(system, options), options).resume(checkpoint);
  }

  /** Goes on with an integration of M y' = f(t, y). */
  public static OdeSolution resume(
      MassProblem problem, OdeCheckpoint checkpoint, OdeOptions options) {
    double[] slope = new double[problem.dimension()];
    return new IntegrationRun(posed(problem, slope, options), options).resume(checkpoint);
  }

  private static PosedProblem posed(OdeSystem system, OdeOptions options) {
    return new PosedProblem.Explicit(system, options.method());
  }

  private static PosedProblem posed(MassProblem problem, double[] slope, OdeOptions options) {
    boolean explicit =
        switch (options.method()) {
          case ODE113, DE -> true;
          case ODE15S, ODE15SR -> false;
          case AUTO -> problem.explicitKeepsStructure();
        };
    return explicit
        ? new PosedProblem.Explicit(problem.explicit(), options.method())
        : new PosedProblem.Residual(problem.residual(), slope, OdeMethod.ODE15SR);
  }
}
