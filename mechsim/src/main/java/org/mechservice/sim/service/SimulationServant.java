package org.mechservice.sim.service;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.ResultCursorPOATie;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.Variable;
import org.omg.CORBA.DoubleHolder;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.TRANSIENT;

/** One simulation of a session, as clients see it. */
final class SimulationServant implements IMechSimRemoteOperations {
  private final Session session;
  private final SimulationRun run;
  private final RunFacts facts;
  private final ModelDescription description;
  private final List<Variable> columns;
  private final Map<ResultCursorServant, ActiveObject> cursors = new HashMap<>();
  private boolean ended;

  SimulationServant(
      Session session,
      SimulationRun run,
      RunFacts facts,
      ModelDescription description,
      List<Variable> columns) {
    this.session = session;
    this.run = run;
    this.facts = facts;
    this.description = description;
    this.columns = columns;
  }

  @Override
  public String simId() {
    return run.simId();
  }

  @Override
  public void start() throws InvalidState {
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
    }
  }

  private static TRANSIENT closing() {
    Thread.currentThread().interrupt();
    return new TRANSIENT("the server is closing");
  }

  @Override
  public void runTo(double untilTime) throws InvalidState {
    run.runTo(untilTime);
  }

  @Override
  public void cancel() {
    run.cancel();
  }

  @Override
  public Progress getProgress() {
    return run.progress();
  }

  @Override
  public Channel[] stateChannels() {
    return Wire.channels(run.states());
  }

  /** The state of the latest result row; of the start before the first one. */
  @Override
  public double[] getStates(DoubleHolder simTime) {
    double[] time = new double[1];
    double[] state = run.lastState(time);
    simTime.value = time[0];
    return state;
  }

  /** None: this version folds all parameters into the generated class. */
  @Override
  public Parameter[] parameters() {
    return new Parameter[0];
  }

  @Override
  public void setParameters(NameValue[] values) throws NotAvailable {
    throw Refusal.notAvailable(
        "setting parameters is not in this version: change the file and load it again");
  }

  @Override
  public ResultCursor openResults(String[] channelNames) throws NotFound, LimitExceeded {
    ColumnSelection selection = ColumnSelection.of(channelNames, columns, description);
    synchronized (cursors) {
      if (ended) {
        throw new OBJECT_NOT_EXIST("the simulation was destroyed");
      }
      HostLimits limits = session.limits();
      HostLimits.requireBelow(limits.cursors(), cursors.size(), "cursors", "cursors of one run");
      ResultCursorServant cursor =
          new ResultCursorServant(run.spool(), selection, this::renewLease, this::close);
      ActiveObject object =
          session.activate(
              new ResultCursorPOATie(
                  GuardedServant.of(ResultCursorOperations.class, cursor, session::renew)));
      cursors.put(cursor, object);
      return ResultCursorHelper.unchecked_narrow(object.reference());
    }
  }

  private void close(ResultCursorServant cursor) {
    synchronized (cursors) {
      ActiveObject object = cursors.remove(cursor);
      if (object != null) {
        object.close();
      }
    }
  }

  /** Ends all cursors; there will be no new ones. */
  void closeCursors() {
    synchronized (cursors) {
      ended = true;
      cursors.values().forEach(ActiveObject::close);
      cursors.clear();
    }
  }

  @Override
  public String report() throws InvalidState {
    return facts.json(requireReport());
  }

  private RunReport requireReport() throws InvalidState {
    if (!run.ended()) {
      throw Refusal.state(run.state(), "the simulation has not ended: there is no report yet");
    }
    return run.report()
        .orElseThrow(
            () -> Refusal.state(run.state(), "the simulation was cancelled before it began"));
  }

  @Override
  public FailureRecord failure() throws InvalidState {
    if (run.state() != SimState.SIM_FAILED
        || !(requireReport().outcome() instanceof Outcome.Failed failed)) {
      throw Refusal.state(run.state(), "the simulation has not failed");
    }
    return Wire.failure(failed.failure());
  }

  @Override
  public byte[] checkpoint() throws NotAvailable {
    throw Refusal.notAvailable("checkpoints are not in this version");
  }

  @Override
  public void restore(byte[] checkpointFile) throws NotAvailable {
    throw Refusal.notAvailable("checkpoints are not in this version");
  }

  @Override
  public int renewLease() {
    return session.limits().leaseSeconds();
  }

  @Override
  public void destroy() {
    session.destroy(run);
  }
}
