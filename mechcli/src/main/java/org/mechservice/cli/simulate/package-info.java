/**
 * One run and its results: {@code mech simulate} and {@code mech fetch}.
 *
 * <p>{@link org.mechservice.cli.simulate.SimulateCommand} connects, loads the model, prepares a
 * remote or a local run, and writes its rows. {@link org.mechservice.cli.simulate.FetchCommand}
 * does the same for a run that an earlier client started. {@link
 * org.mechservice.cli.simulate.ResultOptions} and {@link org.mechservice.cli.simulate.ResultFiles}
 * are shared by both: the files of the rows appear under their names only when they are complete,
 * the run report goes to the terminal, and the outcome becomes the exit status.
 *
 * <p>{@link org.mechservice.cli.simulate.ProgressDisplay} shows how far the run is, with the
 * progress and the warnings that {@link org.mechservice.cli.simulate.RunFollower} collects. {@link
 * org.mechservice.cli.simulate.CancelOnInterrupt} turns Ctrl-C into a cancelled run whose rows are
 * kept. {@link org.mechservice.cli.simulate.CheckpointOptions} writes checkpoints and resumes from
 * one.
 */
@NullMarked
package org.mechservice.cli.simulate;

import org.jspecify.annotations.NullMarked;
