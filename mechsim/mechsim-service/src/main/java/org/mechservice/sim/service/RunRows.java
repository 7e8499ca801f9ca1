package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.Variable;

/** What a run puts out: its rows, and the state it has reached. Thread-safe. */
final class RunRows implements ResultSink {
  /** How long who asks for the state waits for the end of a step. */
  private static final long STATE_MILLIS = 500;

  private final ResultSpool spool;
  private final RunColumnsWatch watch;
  private final RunControl control;
  private final double[] lastState;
  private final Object stateWatch = new Object();
  private double lastTime;
  private boolean closed;

  /**
   * @param task the run as it is before its start
   * @param spool where the rows go
   */
  RunRows(RunTask task, RunColumns columns, ResultSpool spool, RunControl control) {
    this.spool = spool;
    this.control = control;
    watch = new RunColumnsWatch(columns);
    lastState = new double[task.description().stateCount()];
    begin(task);
  }

  /** Takes the start of a run whose parameters have changed. */
  synchronized void begin(RunTask task) {
    lastTime = task.settings().tStart();
    task.initialState(lastState);
  }

  ResultSpool spool() {
    return spool;
  }

  RunColumnsWatch watch() {
    return watch;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    if (columns.size() != spool.columns()) {
      throw new IOException(
          "the solver puts out " + columns.size() + " columns, expected " + spool.columns());
    }
  }

  @Override
  public synchronized void row(double[] values) throws IOException {
    if (closed) {
      throw new IOException("the run was taken for ended");
    }
    lastTime = values[0];
    System.arraycopy(values, 1, lastState, 0, lastState.length);
    watch.row(values);
    spool.append(values);
  }

  /** Takes no more rows: a run that comes back late is not to add to what was called complete. */
  synchronized void close() {
    closed = true;
  }

  /** Returns the time of the last row, s; of the start if there is none. */
  synchronized double lastTime() {
    return lastTime;
  }

  /**
   * Returns the state at the last step, also of a run that is held; of the last row if the run has
   * ended, is computed in a process of its own or is in a long step; of the start before it begins.
   *
   * @param time simulated time at 0, s; overwritten
   */
  double[] lastState(double[] time) throws InterruptedException {
    double[] reached = new double[lastState.length];
    synchronized (stateWatch) {
      OptionalDouble at = control.state(reached, STATE_MILLIS);
      if (at.isPresent()) {
        time[0] = at.getAsDouble();
        return reached;
      }
    }
    synchronized (this) {
      time[0] = lastTime;
      return lastState.clone();
    }
  }
}
