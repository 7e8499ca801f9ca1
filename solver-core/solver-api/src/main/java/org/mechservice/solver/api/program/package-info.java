/**
 * What a program gets that uses models: the rows of a run, a run that it steps itself, and the
 * failure of either.
 *
 * <p>The library in process and the client of a server return these types, so that a program reads
 * the same results whichever of the two it uses. {@link
 * org.mechservice.solver.api.program.Trajectory} holds all rows of a run or an analysis with the
 * names and units of their columns; {@link org.mechservice.solver.api.program.RowMemory} is the
 * sink that collects them. {@link org.mechservice.solver.api.program.SteppedModel} advances by
 * steps of communication, between which a program sets inputs; it drives a {@link
 * org.mechservice.solver.api.run.StepwiseRun} of whichever solver came with the model. {@link
 * org.mechservice.solver.api.program.RunFailedException} says why a run could not go on and has the
 * rows up to there.
 *
 * <p>The package depends on {@code solver.api}, its packages {@code result} and {@code run}, and
 * {@code solver.text}.
 */
package org.mechservice.solver.api.program;
