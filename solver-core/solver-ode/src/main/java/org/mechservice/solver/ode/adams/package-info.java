/**
 * Adams predictor-corrector methods of variable step and order, 1 to 13, for problems that are not
 * stiff.
 *
 * <p>{@link Ode113} is the method of the MATLAB ODE Suite, {@link De} the classical program. Both
 * are an {@link AdamsPece} with another error norm and other bounds of the step. {@link AdamsStep}
 * tells one step: it predicts, evaluates, corrects and evaluates again. {@link AdamsCoefficients}
 * holds the coefficients on unequal steps, {@link AdamsHistory} the state and its modified divided
 * differences, {@link AdamsInterpolant} the polynomial of the last step. {@link AdamsOrderControl}
 * estimates errors and chooses order and step. {@link StiffnessMonitor} suspects stiffness from the
 * two evaluations of each step.
 *
 * <p>The mathematics is told in {@link org.mechservice.solver.ode}. The package depends on {@code
 * ode} and {@code ode.step}. Source: L. F. Shampine and M. K. Gordon, <i>Computer Solution of
 * Ordinary Differential Equations</i>, 1975; E. Hairer, S. P. Nørsett and G. Wanner, <i>Solving
 * Ordinary Differential Equations I</i>, III.5 and III.7.
 */
package org.mechservice.solver.ode.adams;
