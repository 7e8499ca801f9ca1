/**
 * Runs of a model: at the server, on this machine, or resumed by another client.
 *
 * <p>The interface: {@link org.mechservice.client.run.PreparedRun} is a run that is ready to start;
 * {@link org.mechservice.client.run.RemoteRun} runs at the server, {@link
 * org.mechservice.client.run.LocalRun} on this machine: confined, or in this process, as its {@link
 * org.mechservice.client.run.LocalComputation} does. {@link
 * org.mechservice.client.run.ReattachedRun} is a run that another client started. {@link
 * org.mechservice.client.run.RunResult} is the outcome and the report, {@link
 * org.mechservice.client.run.RunProgress} an intermediate state, {@link
 * org.mechservice.client.run.RunListener} receives both, and a {@link
 * org.mechservice.client.run.CheckpointStore} stores checkpoints.
 *
 * <p>Behind it: a remote run pulls its rows with a {@code RowCursor} from its present host, a
 * {@code HostedRun}. When an operator drains the host, a {@code DrainNotice} reports it and a
 * {@code RunMigration} continues the run from its checkpoint on another host. {@code LeaseRenewal}
 * keeps the objects at the server alive. {@code FailureReader} and {@code ReportJson} translate
 * what the contract carries into the types of {@code solver.api}.
 *
 * <p>The package depends on {@code client.failure}, the contract, {@code guard} and {@code
 * solver.api}.
 */
@NullMarked
package org.mechservice.client.run;

import org.jspecify.annotations.NullMarked;
