/**
 * The reference solution of a scene, against which a report measures errors.
 *
 * <p>{@link org.mechservice.report.solution.ReferenceMaker} solves the scene with two codes of
 * {@code report.reference} on two formulations, at the rows of a {@link
 * org.mechservice.report.solution.RunGrid}. Where the two differ by less than they claim, their
 * solution is a {@link org.mechservice.report.solution.Reference} with the accuracy it has at each
 * row. {@link org.mechservice.report.solution.PublishedReference} is one that comes with the
 * product: closed forms and published tables.
 *
 * <p>{@link org.mechservice.report.solution.Judge} decides which of these can serve, and says why
 * not if none can. {@link org.mechservice.report.solution.ReferenceFile} keeps a reference on disk,
 * so that a report that is made again need not solve the scene again.
 *
 * <p>{@link org.mechservice.report.solution.StateDistance} measures the distance of two states as
 * the largest |x − x_ref| / (1 + |x_ref|); the four Euler parameters of a rotation count as the
 * rotation that they mean.
 */
@NullMarked
package org.mechservice.report.solution;

import org.jspecify.annotations.NullMarked;
