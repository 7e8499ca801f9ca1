/**
 * Many runs of a model: {@code mech study} and {@code mech sweep}.
 *
 * <p>{@link org.mechservice.cli.sweep.StudyCommand} runs what a study file describes: in this
 * process, on the hosts of a server ({@link org.mechservice.cli.sweep.HostsEvaluation}), or on a
 * cluster by Spark's own program ({@link org.mechservice.cli.sweep.SparkSubmit}). {@link
 * org.mechservice.cli.sweep.StudyJoinCommand} puts parts of it together.
 *
 * <p>{@link org.mechservice.cli.sweep.SweepCommand} is the short form: it writes a study of a grid
 * from its options ({@link org.mechservice.cli.sweep.SweepRange}), and {@link
 * org.mechservice.cli.sweep.StudyRun} runs it as it runs a study from a file: on the threads of
 * this process or on hosts, with the same journal, table and provenance.
 */
@NullMarked
package org.mechservice.cli.sweep;

import org.jspecify.annotations.NullMarked;
