/**
 * What every method shares in the course of an integration.
 *
 * <p>{@link SteppingIntegrator} is the base of the methods: it holds the settings and the {@link
 * IntegrationProgress}, which knows the present step, the counters ({@link RejectionCounts}, {@link
 * RecentSteps}) and the reason of a failure. {@link StepBounds} says where a step may end; {@link
 * ExactEndBounds} ends the last step at the end, {@link PastEndBounds} steps past it and
 * interpolates, as DE does.
 *
 * <p>A {@link StepWatch} sees each {@link TriedStep}, that of an Adams method as an {@link
 * ExtrapolatedStep}, and may have it taken otherwise; a {@link WatchedIntegrator} takes one, and
 * has none to begin with.
 *
 * <p>{@link RightHandSide} evaluates f, counts the evaluations and obeys the stop signal; {@link
 * Breakpoints} keeps the jumps that a problem declares, so that steps end there and nothing is
 * evaluated across. {@link Manifold} completes and projects a state and scales groups of unit norm
 * back. {@link ErrorNorm} measures errors in units of the tolerance: {@link MaximumNorm} component
 * by component, {@link EuclideanNorm} by the root of the sum of squares.
 *
 * <p>The types are public for the rooms of the methods; users of the library need none of them. The
 * package depends on {@code ode} alone. Source: L. F. Shampine and M. K. Gordon, <i>Computer
 * Solution of Ordinary Differential Equations</i>, 1975.
 */
package org.mechservice.solver.ode.step;
