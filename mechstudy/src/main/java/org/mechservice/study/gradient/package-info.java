/**
 * Exact derivatives of results by parameters and start values.
 *
 * <p>{@link org.mechservice.study.gradient.Gradients} is the main type: a model, outputs reduced to
 * numbers, and what they are differentiated by. It computes in one of two ways. {@code ForwardRun}
 * integrates the tangents of the state together with the state; a point costs about as much as one
 * run for each parameter. {@code AdjointRun} integrates the state, and then the derivatives of one
 * number by the state backwards in time; a number costs about as much as three or four runs,
 * whatever the number of parameters. {@code SolutionSegments} keeps the motion for the way back
 * within a bounded memory.
 *
 * <p>{@code GradientModel} has the directions of differentiation. Events with changes of the state,
 * and jumps of the equations, happen at times that depend on the parameters; {@code Transition}
 * carries tangents and adjoints across them (saltation). {@code Observation} finds extremes and
 * crossings between steps.
 *
 * <p>Sources: Y. Cao, S. Li, L. Petzold, R. Serban, Adjoint sensitivity analysis for
 * differential-algebraic equations, SIAM J. Sci. Comput. 24 (2003); S. Galán, W. F. Feehery, P. I.
 * Barton, Parametric sensitivity functions for hybrid discrete/continuous systems, Appl. Numer.
 * Math. 31 (1999).
 */
@NullMarked
package org.mechservice.study.gradient;

import org.jspecify.annotations.NullMarked;
