/**
 * Optimum design: the values of parameters for which an objective is least and constraints hold.
 *
 * <p>A {@link org.mechservice.study.optimise.DesignProblem} names the variables with their bounds,
 * what is wanted of which quantity, and a {@link org.mechservice.study.optimise.Response} that
 * computes the quantities at a point: a run of a model, or any function. {@link
 * org.mechservice.study.optimise.Optimiser} starts once or several times, at once where there are
 * threads, and returns the {@link org.mechservice.study.optimise.Optimum} with every point tried.
 *
 * <p>All methods work on the unit cube of the variables' ranges, and with objectives and
 * constraints scaled by their sizes, so that units do not matter. Levenberg-Marquardt, BOBYQA,
 * CMA-ES and Brent's method are those of Commons Math, sequential quadratic programming is that of
 * Hipparchus; constraints reach the methods without derivatives by an augmented Lagrangian.
 *
 * <p>A point that fails ends its start, unless the user has said what objective such points have;
 * it stands in the history with the reason either way.
 */
@NullMarked
package org.mechservice.study.optimise;

import org.jspecify.annotations.NullMarked;
