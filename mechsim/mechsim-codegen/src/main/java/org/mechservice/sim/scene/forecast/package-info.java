/**
 * Forecasts: findings about a run before it begins.
 *
 * <p>{@link org.mechservice.sim.scene.forecast.RunForecast} collects the findings, each of which
 * has a class of its own: joints so stiff or bodies that spin so fast that a run takes millions of
 * steps, formulas of time and velocity that keep steps tiny, pulses shorter than a step, masses
 * that leave the accelerations too few digits, bodies that nothing moves, and methods that keep
 * dense matrices of a large mechanism. {@code mech check} prints them, and a session gives them to
 * its client before the first step.
 *
 * <p>A forecast considers the start alone: it is computed from the model and the settings of the
 * run. Only where a fast motion may take very many steps are the first of them taken ({@code
 * TrialSteps}). Depends on the analysis of scenes beside it and on the data-driven equations of
 * solver-mechanics; a {@link org.mechservice.sim.scene.Finding} has a code of the error catalogue.
 */
@NullMarked
package org.mechservice.sim.scene.forecast;

import org.jspecify.annotations.NullMarked;
