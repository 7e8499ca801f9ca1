/**
 * The equations of an implicit step and the simplified Newton iteration that solves them.
 *
 * <p>{@link StepSolver} solves a step. {@link StepEquations} is the problem it solves: {@link
 * ExplicitEquations} for y' = f(t, y), {@link ResidualEquations} for F(t, y, y') = 0. {@link
 * NewtonIteration} runs the iteration by {@link IterationRules}; {@link ResidualMonitor} watches
 * what the iteration leaves of the equations, and {@link NegligibleResidual} tells how much of that
 * does not matter. {@link NewtonMatrixFactors} and {@link JacobianPolicy} decide when factors and
 * derivatives are formed anew; {@link MatrixDrift} measures how fast a matrix that moves with the
 * state outdates its factors.
 *
 * <p>Derivatives come from the problem or from differences: {@link JacobianDifferences} chooses the
 * increments, {@link ColumnGroups} differences columns together that share no row, and a {@link
 * ColumnTest} may look at the columns formed. {@link JacobianMatrix} stores one matrix of
 * derivatives. In residual form {@link ResidualLinearisation} hides whether the library stores the
 * two matrices ({@link ResidualJacobians}) or the problem solves its own equations ({@link
 * UserLinearisation}).
 *
 * <p>{@link ConsistentStart} finds initial values that obey F = 0, {@link InitialStepSize} the
 * first step.
 *
 * <p>The package depends on {@code ode}, {@code ode.step}, {@code ode.backward} and {@code linear}.
 * Source: E. Hairer and G. Wanner, <i>Solving Ordinary Differential Equations II</i>, IV.8 and
 * VI.1; K. E. Brenan, S. L. Campbell and L. R. Petzold, <i>Numerical Solution of Initial-Value
 * Problems in Differential-Algebraic Equations</i>, 1996, ch. 5; D. E. Salane, SAND86-1319 (1986).
 */
package org.mechservice.solver.ode.newton;
