package org.mechservice.sim.service.session;

import java.util.Map;
import java.util.TreeMap;
import org.mechservice.idl.Channel;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.InvalidOption;
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
import org.mechservice.sim.service.run.SimulationRun;
import org.omg.CORBA.DoubleHolder;
import org.omg.CORBA.TRANSIENT;

/** One simulation of a session, as clients see it. */
final class SimulationServant implements IMechSimRemoteOperations {
  private final Session session;
  private final SimulationRun run;
  private final ResultCursors cursors;

  SimulationServant(Session session, SimulationRun run) {
    this.session = session;
    this.run = run;
    cursors = new ResultCursors(session, run.spool(), run.columns());
  }

  @Override
  public String simId() {
    return run.simId();
  }

  @Override
  public void start() throws InvalidState, LimitExceeded {
    run.start();
  }

  @Override
  public void pause() throws InvalidState {
    try {
      run.pause();
    } catch (InterruptedException e) {
      throw closing();
    }
  }

  @Override
  public void resume() throws InvalidState {
    run.resume();
  }

  @Override
  public void stepOnce() throws InvalidState {
    try {
      run.stepOnce();
    } catch (InterruptedException e) {
      throw closing();
    } catch (LimitExceeded e) {
      throw tooManyWait(e);
    }
  }

  /** In the contract only start throws LimitExceeded, not a step that starts the run. */
  private InvalidState tooManyWait(LimitExceeded refusal) {
    return new InvalidState(refusal.code, refusal.text, run.state());
  }

  private static TRANSIENT closing() {
    Thread.currentThread().interrupt();
    return new TRANSIENT("the server is closing");
  }

  @Override
  public void runTo(double untilTime) throws InvalidState {
    try {
      run.runTo(untilTime);
    } catch (LimitExceeded e) {
      throw tooManyWait(e);
    }
  }

  @Override
  public void cancel() {
    try {
      run.cancel();
    } catch (InterruptedException e) {
      throw closing();
    }
  }

  @Override
  public Progress getProgress() {
    return run.progress();
  }

  @Override
  public Channel[] stateChannels() {
    return ContractTypes.channels(run.states());
  }

  /** The state at the last step, between rows too; of the last row once the run has ended. */
  @Override
  public double[] getStates(DoubleHolder simTime) {
    double[] time = new double[1];
    try {
      double[] state = run.lastState(time);
      simTime.value = time[0];
      return state;
    } catch (InterruptedException e) {
      throw closing();
    }
  }

  @Override
  public Parameter[] parameters() {
    return run.parameters().stream()
        .map(p -> new Parameter(p.name(), p.unit(), p.value(), true))
        .toArray(Parameter[]::new);
  }

  @Override
  public void setParameters(NameValue[] values) throws InvalidOption, InvalidState {
    Map<String, String> texts = new TreeMap<>();
    for (NameValue value : values) {
      texts.put(value.key, value.text);
    }
    try {
      run.setParameters(texts);
    } catch (IllegalArgumentException e) {
      throw ContractErrors.parameter(e);
    }
  }

  @Override
  public ResultCursor openResults(String[] channelNames) throws NotFound, LimitExceeded {
    return cursors.open(channelNames);
  }

  /** Opens a cursor over all columns. */
  ResultCursor openAllResults() throws LimitExceeded {
    return cursors.openAll();
  }

  /** Closes its cursors; no new ones can be opened. */
  void closeCursors() {
    cursors.close();
  }

  @Override
  public String report() throws InvalidState {
    if (!run.ended()) {
      throw ContractErrors.state(
          run.state(), "the simulation has not ended: there is no report yet");
    }
    return run.report()
        .orElseThrow(
            () ->
                ContractErrors.state(run.state(), "the simulation was cancelled before it began"));
  }

  @Override
  public FailureRecord failure() throws InvalidState {
    return run.failure()
        .map(ContractTypes::failure)
        .orElseThrow(() -> ContractErrors.state(run.state(), "the simulation has not failed"));
  }

  @Override
  public byte[] checkpoint() throws InvalidState, NotAvailable {
    try {
      return run.checkpoint();
    } catch (InterruptedException e) {
      throw closing();
    }
  }

  @Override
  public void restore(byte[] checkpointFile) throws InvalidState, NotAvailable {
    run.restore(checkpointFile);
  }

  @Override
  public int renewLease() {
    return session.limits().leaseSeconds();
  }

  /** When this returns, the end of the run is recorded. */
  @Override
  public void destroy() {
    try {
      run.end();
    } catch (InterruptedException e) {
      throw closing();
    }
    session.destroy(run);
  }
}
