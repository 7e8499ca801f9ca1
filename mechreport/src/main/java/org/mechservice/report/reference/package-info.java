/**
 * The report's own integrators, independent of those under test.
 *
 * <p>{@link org.mechservice.report.reference.RadauCode} is Radau IIA of 5 or 7 stages (Hairer and
 * Wanner, Solving Ordinary Differential Equations II, 1996, section IV.8), {@link
 * org.mechservice.report.reference.ExtrapolationCode} a Gragg-Bulirsch-Stoer extrapolation (Hairer,
 * Nørsett and Wanner, part I, 1993, section II.9). Both solve a {@link
 * org.mechservice.report.reference.Problem} far below every tolerance that is reported.
 *
 * <p>{@link org.mechservice.report.reference.PhaseIntegration} takes either code through the phases
 * of a motion: {@link org.mechservice.report.reference.ZeroCrossings} finds where an event function
 * changes sign, and the step is shortened until it ends there, so no dense output takes part.
 * {@link org.mechservice.report.reference.CompensatedState} sums the increments with compensation.
 */
@NullMarked
package org.mechservice.report.reference;

import org.jspecify.annotations.NullMarked;
