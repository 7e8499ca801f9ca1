/**
 * The suite of stiff and extreme scenes behind {@code mech stability}.
 *
 * <p>An {@link org.mechservice.report.stability.ExtremeCase} is a scene with the outcome that is
 * expected of it: a motion that a reference judges, a refusal with a message, or a failure with a
 * message. {@link org.mechservice.report.stability.StabilityReport} runs each case with every
 * method that fits and that a {@link org.mechservice.report.stability.SuiteBuilds} has built,
 * within a {@link org.mechservice.report.stability.SuiteTimeBudget}, and collects a {@link
 * org.mechservice.report.stability.CaseOutcome} with one {@link
 * org.mechservice.report.stability.MethodOutcome} per method. {@link
 * org.mechservice.report.stability.StabilityPage} writes the page. The scenes come from
 * examples/extremes and lie in the JAR.
 */
@NullMarked
package org.mechservice.report.stability;

import org.jspecify.annotations.NullMarked;
