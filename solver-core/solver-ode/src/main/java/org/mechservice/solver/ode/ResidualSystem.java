package org.mechservice.solver.ode;

/**
 * A problem in residual form, F(t, y, y') = 0.
 *
 * <p>Components whose derivative does not appear in F (multipliers, say) are algebraic; {@link
 * Component} tells the integrator what each one is.
 */
public interface ResidualSystem extends SystemParts {
  /** Returns the number of components, which is that of the equations. */
  int dimension();

  /**
   * Evaluates the residual.
   *
   * @param t where
   * @param y state, length {@link #dimension()}; not modified
   * @param yDot its derivative; not modified
   * @param residual F(t, y, y'); overwritten. A value that is not finite says that F is not defined
   *     there: the step is then tried shorter
   */
  void residual(double t, double[] y, double[] yDot, double[] residual);

  /**
   * Returns what a component is.
   *
   * @param index from 0
   */
  default Component component(int index) {
    return Component.DIFFERENTIAL;
  }

  /** Returns whether ∂F/∂y' changes with the state, as the mass matrix of a mechanism does. */
  default boolean massMatrixMoves() {
    return false;
  }

  /** The kind of a component of a residual system, for the error test and the convergence test. */
  enum Component {
    /** Its derivative appears in F; it is held to the tolerance. */
    DIFFERENTIAL,
    /**
     * Its derivative does not appear; it is in neither test, only required to be finite
     * (docs/theory/integrators.md#backward-differentiation).
     */
    ALGEBRAIC
  }
}
