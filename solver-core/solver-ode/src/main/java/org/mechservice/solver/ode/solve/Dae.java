package org.mechservice.solver.ode.solve;

import java.util.BitSet;
import org.mechservice.solver.ode.ResidualSystem;

/**
 * Integrates differential-algebraic problems in residual form, F(t, y, y') = 0, of index at most 1,
 * in one call:
 *
 * <pre>{@code
 * // y0' = -y0, and y1 the square of y0.
 * DaeProblem square = Dae.system(2, (t, y, yDot, r) -> {
 *   r[0] = yDot[0] + y[0];
 *   r[1] = y[1] - y[0] * y[0];
 * }).withAlgebraic(1);
 * OdeSolution solution = Dae.solve(square, 0, new double[] {1, 0}, new double[2], 5);
 * }</pre>
 *
 * <p>The start is made consistent first: y' and the algebraic part of y are corrected until F(t0,
 * y0, y'0) = 0. The end may lie before the start.
 */
public final class Dae {
  private Dae() {}

  /** Returns a problem with n unknowns, to which parts can be added. */
  public static DaeProblem system(int dimension, DaeFunction function) {
    return new DaeProblem(dimension, function, PartsOfProblem.NONE, new BitSet(), false);
  }

  /** Returns a system with all its parts as a problem to which others can be added. */
  public static DaeProblem system(ResidualSystem system) {
    return DaeProblem.of(system);
  }

  /** Integrates F(t, y, y') = 0 with the {@linkplain OdeOptions#standard standard options}. */
  public static OdeSolution solve(
      DaeFunction function, double t0, double[] y0, double[] yDot0, double t1) {
    return solve(function, t0, y0, yDot0, t1, OdeOptions.standard());
  }

  /** Integrates F(t, y, y') = 0. */
  public static OdeSolution solve(
      DaeFunction function, double t0, double[] y0, double[] yDot0, double t1, OdeOptions options) {
    return solve(system(y0.length, function), t0, y0, yDot0, t1, options);
  }

  /** Integrates F(t, y, y') = 0 with the standard options. */
  public static OdeSolution solve(
      ResidualSystem system, double t0, double[] y0, double[] yDot0, double t1) {
    return solve(system, t0, y0, yDot0, t1, OdeOptions.standard());
  }

  /**
   * Integrates F(t, y, y') = 0 with all that the system tells of itself.
   *
   * @param y0 state at the start, its algebraic part a guess; not modified
   * @param yDot0 guess of its derivative; not modified
   * @throws IntegrationException if the end cannot be reached and {@link OdeOptions#returnFailures}
   *     was not asked for
   * @throws IllegalArgumentException if something given is not finite or of the wrong length, or if
   *     the method takes y' = f(t, y) only
   */
  public static OdeSolution solve(
      ResidualSystem system,
      double t0,
      double[] y0,
      double[] yDot0,
      double t1,
      OdeOptions options) {
    OdeSolution.requireLength("yDot0", yDot0, system.dimension());
    return new IntegrationRun(posed(system, yDot0, options), options).solve(t0, y0, t1);
  }

  /**
   * Goes on with an integration of the same problem and options from a checkpoint; the solution
   * begins there.
   *
   * @throws IllegalArgumentException if the bytes are damaged or belong to another problem, method
   *     or tolerance
   */
  public static OdeSolution resume(
      ResidualSystem system, OdeCheckpoint checkpoint, OdeOptions options) {
    double[] slope = new double[system.dimension()];
    return new IntegrationRun(posed(system, slope, options), options).resume(checkpoint);
  }

  private static PosedProblem posed(ResidualSystem system, double[] slope, OdeOptions options) {
    return new PosedProblem.Residual(system, slope, options.method());
  }
}
