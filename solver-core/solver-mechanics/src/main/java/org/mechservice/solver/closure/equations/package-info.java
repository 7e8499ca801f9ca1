/**
 * The equations of closed loops: constraints between the two sides of cut joints, rods, couplings
 * and points on lines and planes.
 *
 * <p>{@link org.mechservice.solver.closure.equations.LoopEquations} evaluates Φ(q, t), its Jacobian
 * by the tree velocities, and the right-hand side of the acceleration equations. {@link
 * org.mechservice.solver.closure.equations.PairRows} writes the rows of one cut joint, {@link
 * org.mechservice.solver.closure.equations.CouplingRows} those of couplings between coordinates.
 * {@link org.mechservice.solver.closure.equations.LoopTerms} is the interface of generated code for
 * the same terms.
 *
 * <p>{@link org.mechservice.solver.closure.equations.LengthScale} makes rows in m and rad
 * comparable, and {@link org.mechservice.solver.closure.equations.LoopRounding} estimates the
 * rounding errors of residuals. {@link org.mechservice.solver.closure.equations.UnwrappedAngles}
 * counts whole turns of cut joints from one accepted step to the next.
 */
package org.mechservice.solver.closure.equations;
