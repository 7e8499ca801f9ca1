/**
 * Errors and times of a report.
 *
 * <p>Errors are measured against the reference solution of {@code report.solution}.
 *
 * <p>{@link org.mechservice.report.measure.Campaign} runs every candidate at every tolerance:
 * {@link org.mechservice.report.measure.MethodRunner} makes one {@link
 * org.mechservice.report.measure.MeasuredRun}, {@link org.mechservice.report.measure.WarmUpRounds}
 * repeats rounds until the compiler has finished, and {@link
 * org.mechservice.report.measure.MeasurementFile} keeps all runs, so that an interrupted report can
 * continue. {@link org.mechservice.report.measure.Point} condenses the repeated runs of a point to
 * median and quartiles ({@link org.mechservice.report.measure.Quantiles}). {@link
 * org.mechservice.report.measure.Spectrum} has the eigenvalues along the reference, {@link
 * org.mechservice.report.measure.TimeShares} how a run's time divides, {@link
 * org.mechservice.report.measure.ColdRunTiming} the times of first runs, {@link
 * org.mechservice.report.measure.Rerun} the comparison of two reports. {@link
 * org.mechservice.report.measure.SceneFindings} puts together all that was found of a {@linkplain
 * org.mechservice.report.measure.ReportedScene scene}, for the pages.
 */
@NullMarked
package org.mechservice.report.measure;

import org.jspecify.annotations.NullMarked;
