package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.switching.Switching;

/**
 * The integration methods. All keep the local error below max(rtol |y_i|, atol_i) in every
 * component but {@link #DE}, and all integrate in either direction.
 *
 * <table>
 * <caption>Order, memory in numbers of 8 bytes for n unknowns, source</caption>
 * <tr><th>method</th><th>order</th><th>memory</th><th>after</th></tr>
 * <tr><td>{@link #ODE113}, {@link #DE}</td><td>1-13</td><td>75 n</td><td>Shampine and Gordon
 * 1975</td></tr>
 * <tr><td>{@link #ODE15S}</td><td>1-5</td><td>95 n and four matrices</td><td>Shampine and Reichelt
 * 1997</td></tr>
 * <tr><td>{@link #ODE15SR}</td><td>1-5</td><td>165 n and ten matrices</td><td>Petzold 1982; Brenan,
 * Campbell and Petzold 1996</td></tr>
 * <tr><td>{@link #AUTO}</td><td>1-13, 1-5</td><td>95 n, and that of ODE15S from when it is
 * needed</td><td>Petzold 1983</td></tr>
 * </table>
 *
 * <p>A matrix has n² numbers, or n (l + u + 1) with a band. The classes {@link Ode113}, {@link De},
 * {@link Ode15s}, {@link Ode15sR} and {@link Switching} tell more of each.
 */
public enum OdeMethod {
  /**
   * Adams methods while the problem is not stiff, differentiation formulas where it is. For
   * problems in residual form, and with a mass matrix that is singular or not diagonal, ode15sR.
   */
  AUTO,
  /** Adams predictor-corrector methods of order 1 to 13: smooth problems that are not stiff. */
  ODE113,
  /**
   * The same formulas with the bounds and the norm of the program DE: the root of the sum of
   * squares of error / (rtol |y_i| + atol_i) is at most 1.
   */
  DE,
  /** Numerical differentiation formulas of order 1 to 5: stiff problems. */
  ODE15S,
  /** The same for F(t, y, y') = 0: algebraic equations of index 1, any mass matrix. */
  ODE15SR;

  /** Returns an integrator for y' = f(t, y). */
  WatchedIntegrator integrator(IntegratorSettings settings) {
    return switch (this) {
      case AUTO -> new Switching(settings);
      case ODE113 -> new Ode113(settings);
      case DE -> new De(settings);
      case ODE15S -> new Ode15s(settings);
      case ODE15SR -> new Ode15sR(settings);
    };
  }

  /**
   * Returns an integrator for F(t, y, y') = 0.
   *
   * @throws IllegalArgumentException if this method takes none
   */
  Ode15sR residualIntegrator(IntegratorSettings settings) {
    if (this != AUTO && this != ODE15SR) {
      throw new IllegalArgumentException(
          "method "
              + this
              + " integrates y' = f(t, y) only; for F(t, y, y') = 0 use ODE15SR or AUTO");
    }
    return new Ode15sR(settings);
  }
}
