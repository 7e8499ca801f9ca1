/**
 * Many runs of a model: {@code mech study} and {@code mech sweep}.
 *
 * <p>{@link org.mechservice.cli.sweep.StudyCommand} runs what a study file describes: in this
 * process, on the hosts of a server ({@link org.mechservice.cli.sweep.HostsEvaluation}), or on a
 * cluster by Spark's own program ({@link org.mechservice.cli.sweep.SparkSubmit}). {@link
 * org.mechservice.cli.sweep.StudyJoinCommand} puts parts of it together. {@code mech sweep} runs
 * every combination of parameter values over the hosts of a server.
 *
 * <p>{@link org.mechservice.cli.sweep.SweepCommand} reads the values ({@link
 * org.mechservice.cli.sweep.SweepRange}), lets {@link org.mechservice.client.sweep.Sweep} run the
 * points over all hosts of a server, and writes one row per point ({@link
 * org.mechservice.cli.sweep.SweepTable}): the values, the outcome, the last row of the run, figures
 * of its report.
 *
 * <p>{@link org.mechservice.cli.sweep.SweepJournal} keeps the points that are done in {@code
 * FILE.csv.part}. The same command, given again after an interruption, reads that file and runs the
 * remaining points only; the finished table does not depend on the order in which points ended.
 */
@NullMarked
package org.mechservice.cli.sweep;

import org.jspecify.annotations.NullMarked;
