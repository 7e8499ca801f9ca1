/**
 * The results of runs: their rows in memory and on disk, and the records of runs that have ended.
 *
 * <p>A running solver appends rows to a {@link org.mechservice.sim.service.results.ResultSpool};
 * any number of {@link org.mechservice.sim.service.results.ResultCursors} read them meanwhile.
 * {@link org.mechservice.sim.service.results.RunColumns} names the columns and selects some of
 * them.
 *
 * <p>{@link org.mechservice.sim.service.results.RunStore} keeps the runs whose session has ended.
 * With a {@link org.mechservice.sim.service.results.SpoolFolder} they outlive the process: for each
 * run the folder contains a {@link org.mechservice.sim.service.results.RunRecord} as JSON and the
 * rows as big-endian doubles. {@link org.mechservice.sim.service.results.RunFiles} writes both, so
 * that a crash leaves either the old or the new record.
 *
 * <p>Depends on the packages {@code contract} and {@code limits}.
 */
@NullMarked
package org.mechservice.sim.service.results;

import org.jspecify.annotations.NullMarked;
