package org.mechservice.sim.service.session;

import org.mechservice.idl.Channel;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Parameter;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultCursor;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.results.ResultCursors;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.solver.api.result.Variable;
import org.omg.CORBA.DoubleHolder;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/** An ended run, reopened: its rows and its report; calls that steer a run are refused. */
final class EndedRunServant implements IMechSimRemoteOperations {
  private final Session session;
  private final RunRecord run;
  private final ResultSpool rows;
  private final ResultCursors cursors;
  private final Runnable destroyed;

  /**
   * @param destroyed called when the client destroys its reference; the run is kept
   */
  EndedRunServant(Session session, RunRecord run, ResultSpool rows, Runnable destroyed) {
    this.session = session;
    this.run = run;
    this.rows = rows;
    this.destroyed = destroyed;
    cursors = new ResultCursors(session, rows, run.columns());
  }

  private InvalidState hasEnded(String what) {
    return ContractErrors.state(
        run.progress().state, "the simulation has ended: it cannot be " + what);
  }

  @Override
  public String simId() {
    return run.identity().simId();
  }

  @Override
  public void start() throws InvalidState {
    throw hasEnded("started");
  }

  @Override
  public void pause() throws InvalidState {
    throw hasEnded("paused");
  }

  @Override
  public void resume() throws InvalidState {
    throw hasEnded("resumed");
  }

  @Override
  public void stepOnce() throws InvalidState {
    throw hasEnded("continued");
  }

  @Override
  public void runTo(double untilTime) throws InvalidState {
    throw hasEnded("continued");
  }

  @Override
  public void cancel() {
    // Nothing is left to be cancelled.
  }

  @Override
  public Progress getProgress() {
    return run.progress();
  }

  @Override
  public Channel[] stateChannels() {
    return ContractTypes.channels(run.states());
  }

  /** The state of the last row. */
  @Override
  public double[] getStates(DoubleHolder simTime) throws InvalidState {
    double[] values = lastRow();
    double[] state = new double[run.states().size()];
    for (int i = 0; i < state.length; i++) {
      Variable wanted = run.states().get(i);
      int at = run.columns().indexOf(wanted.name());
      if (at < 0) {
        throw hasEnded("asked for a state: its rows are those of an analysis, without one");
      }
      state[i] = values[at];
    }
    simTime.value = values[0];
    return state;
  }

  private double[] lastRow() throws InvalidState {
    try {
      double[] values = rows.read(Math.max(0, rows.rows() - 1), 1);
      if (values.length == 0) {
        throw hasEnded("asked for a state: it has put out no row");
      }
      return values;
    } catch (java.io.IOException e) {
      throw new OBJECT_NOT_EXIST("the results are not kept any more");
    }
  }

  @Override
  public Parameter[] parameters() {
    return new Parameter[0];
  }

  @Override
  public void setParameters(NameValue[] values) throws InvalidState {
    throw hasEnded("changed");
  }

  @Override
  public ResultCursor openResults(String[] channelNames) throws NotFound, LimitExceeded {
    return cursors.open(channelNames);
  }

  @Override
  public String report() throws InvalidState {
    if (run.report().isEmpty()) {
      throw ContractErrors.state(run.progress().state, "there is no report: " + run.text());
    }
    return run.report();
  }

  @Override
  public FailureRecord failure() throws InvalidState {
    return run.failure()
        .orElseThrow(
            () -> ContractErrors.state(run.progress().state, "the simulation has not failed"));
  }

  @Override
  public byte[] checkpoint() throws NotAvailable {
    throw ContractErrors.notAvailable("of a run that was left no checkpoint is kept");
  }

  @Override
  public void restore(byte[] checkpointFile) throws InvalidState {
    throw hasEnded("restored");
  }

  @Override
  public int renewLease() {
    return session.limits().leaseSeconds();
  }

  @Override
  public void destroy() {
    destroyed.run();
  }

  /** Closes its cursors; no new ones can be opened. */
  void closeCursors() {
    cursors.close();
  }
}
