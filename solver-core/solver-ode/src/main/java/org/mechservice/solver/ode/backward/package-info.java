/**
 * Backward and numerical differentiation formulas of orders 1 to 5, and the backward differences
 * they work on.
 *
 * <p>{@link BackwardDifferences} holds the state and its backward differences, predicts a step and
 * corrects it. {@link RescalingMatrix} writes the differences for another step size. {@link
 * BackwardFormulas} holds the coefficients of both families, {@link UnstableSteps} the steps at
 * which they make oscillations grow. {@link BackwardInterpolant} evaluates the polynomial of the
 * last step. {@link BackwardOrderControl} estimates the errors of neighbouring orders and chooses
 * order and step.
 *
 * <p>The equations of a step are solved in {@code ode.newton}; the methods that use both are in
 * {@code ode.stiff}. The package depends on {@code ode} and {@code ode.step}. Source: L. F.
 * Shampine and M. W. Reichelt, <i>The MATLAB ODE Suite</i>, SIAM J. Sci. Comput. 18 (1997) 1; R. W.
 * Klopfenstein, RCA Review 32 (1971) 447.
 */
package org.mechservice.solver.ode.backward;
