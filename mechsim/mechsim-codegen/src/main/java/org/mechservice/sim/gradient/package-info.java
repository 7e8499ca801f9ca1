/**
 * The equations of a model together with their derivatives: by the state, by time, by parameters
 * and by start values. {@code mech gradient} integrates them.
 *
 * <p>{@link org.mechservice.sim.gradient.DifferentiableFunction} is a program with two more
 * programs recorded from it: the derivatives along directions (tangents) and those of a weighted
 * sum by all inputs (adjoint). Each is written as a class of its own when it is first needed, so
 * models whose gradients nobody asks for contain nothing of them.
 *
 * <p>{@link org.mechservice.sim.gradient.VariationalEquations} are y' = f(t, y, p) with their
 * tangents and adjoint. {@code OpenVariations} differentiates the explicit equations of an open
 * chain. {@code ClosedVariations} differentiates M a + b + Jᵀλ = 0, J a + γ = 0 of a mechanism with
 * loops and solves for the derivatives of a with the factors that gave a.
 *
 * <p>{@link org.mechservice.sim.gradient.ModelFunctions} has all of a model: its equations, the
 * columns of results that are observed ({@code ObservedColumns}), its events, and the places at
 * which its equations jump or have a corner ({@code Switches}). Nothing here integrates; the module
 * {@code mechstudy} does.
 */
@NullMarked
package org.mechservice.sim.gradient;

import org.jspecify.annotations.NullMarked;
