package org.mechservice.solver.ode;

import java.util.Optional;

/**
 * Optional parts of a problem beyond its equations: a {@link BandedSystem band}, a {@link
 * SparseSystem pattern}, a {@link JacobianSystem Jacobian}, {@link PiecewiseSystem breakpoints} and
 * so on. Integrators ask for each part by {@link #part} and never by the class of the problem, so
 * that a problem wrapped around another keeps its parts:
 *
 * <pre>{@code
 * final class Counted implements OdeSystem {
 *   public int dimension() { return inner.dimension(); }
 *   public void derivative(double t, double[] y, double[] yDot) {
 *     count++;
 *     inner.derivative(t, y, yDot);
 *   }
 *   public <T> Optional<T> part(Class<T> kind) { return inner.part(kind); }
 * }
 * }</pre>
 */
public interface SystemParts {
  /**
   * Returns what this problem tells of one kind: itself, if it implements the interface; empty if
   * it tells nothing. Asked when a problem is begun or taken up, not in its steps.
   *
   * @param kind an interface that stands beside {@link OdeSystem} or {@link ResidualSystem}
   */
  default <T> Optional<T> part(Class<T> kind) {
    return kind.isInstance(this) ? Optional.of(kind.cast(this)) : Optional.empty();
  }
}
