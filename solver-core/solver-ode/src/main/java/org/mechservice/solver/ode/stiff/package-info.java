/**
 * Implicit methods of variable step and order, 1 to 5, for stiff problems and for problems in
 * residual form.
 *
 * <p>{@link Ode15s} integrates y' = f(t, y), {@link Ode15sR} F(t, y, y') = 0. Both are a {@link
 * BackwardMethod}, which starts a problem, interpolates and saves; its {@link BackwardStep} takes
 * one step: predict, solve, test the error, choose order and step. {@link StepSize} chooses and
 * bounds the step, {@link ErrorAllowance} says how large an error of a step may be where nothing is
 * stiff.
 *
 * <p>The formulas come from {@code ode.backward} and the solution of the equations from {@code
 * ode.newton}; the mathematics is told in {@link org.mechservice.solver.ode}. Source: L. F.
 * Shampine and M. W. Reichelt, <i>The MATLAB ODE Suite</i>, SIAM J. Sci. Comput. 18 (1997) 1.
 */
package org.mechservice.solver.ode.stiff;
