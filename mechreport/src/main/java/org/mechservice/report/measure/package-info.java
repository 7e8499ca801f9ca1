/**
 * Reference, errors and times of a report.
 *
 * <p>{@link org.mechservice.report.measure.ReferenceMaker} solves the scene with two codes on two
 * formulations, and {@link org.mechservice.report.measure.Judge} decides what of that can serve as
 * {@link org.mechservice.report.measure.Reference}; {@link
 * org.mechservice.report.measure.PublishedReference} is one that comes with the product. {@link
 * org.mechservice.report.measure.StateDistance} measures an error as the largest |x − x_ref| / (1 +
 * |x_ref|).
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
 * org.mechservice.report.measure.SceneFindings} puts together all that was found of a scene, for
 * the pages.
 */
@NullMarked
package org.mechservice.report.measure;

import org.jspecify.annotations.NullMarked;
