package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.idl.CurveSample;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;

/**
 * Takes the rows of a run, and knows the state it has reached and the curves of its energy drift
 * and its constraint residual, as far as the rows contain them. Thread-safe.
 */
final class RunOutput implements ResultSink {
  /** Longest wait for the end of a step when a client reads the state, ms. */
  private static final long STATE_MILLIS = 500;

  private final ResultSpool spool;
  private final RunControl control;
  private final double[] lastState;

  /**
   * Whether the rows have the state behind their time: those of motions. Rows of an analysis, such
   * as modes, need not, and may be shorter.
   */
  private final boolean stateInRows;

  private final Object stateWatch = new Object();
  private final CurveHistory curves = new CurveHistory();
  private final int kineticColumn;
  private final int potentialColumn;
  private final int workColumn;
  private final int residualColumn;
  private double initialEnergy = Double.NaN;

  /** Energy beyond that of the start and the work done, J; NaN if the rows do not contain it. */
  private volatile double energyDrift = Double.NaN;

  /** Largest position residual of the constraints, m or rad; NaN if not in the rows. */
  private volatile double residual = Double.NaN;

  private double lastTime;
  private boolean closed;

  /**
   * @param task the run before its start
   * @param spool receives the rows
   */
  RunOutput(RunTask task, RunColumns columns, ResultSpool spool, RunControl control) {
    this.spool = spool;
    this.control = control;
    kineticColumn = columns.indexOf("energy.kinetic");
    potentialColumn = columns.indexOf("energy.potential");
    workColumn = columns.indexOf("energy.work");
    residualColumn = columns.indexOf("constraint.position");
    List<Variable> states = task.description().states();
    lastState = new double[states.size()];
    List<Variable> variables = columns.variables();
    stateInRows =
        variables.size() > states.size() && variables.subList(1, states.size() + 1).equals(states);
    startFrom(task);
  }

  /** Takes time and state of the start of a run, anew when its parameters have changed. */
  synchronized void startFrom(RunTask task) {
    lastTime = task.settings().tStart();
    task.initialState(lastState);
  }

  ResultSpool spool() {
    return spool;
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
    if (stateInRows) {
      System.arraycopy(values, 1, lastState, 0, lastState.length);
    }
    observe(values);
    sampleCurves(lastTime);
    spool.append(values);
  }

  private void observe(double[] values) {
    if (kineticColumn >= 0 && potentialColumn >= 0) {
      double energy =
          values[kineticColumn]
              + values[potentialColumn]
              - (workColumn >= 0 ? values[workColumn] : 0);
      if (Double.isNaN(initialEnergy)) {
        initialEnergy = energy;
      }
      energyDrift = energy - initialEnergy;
    }
    if (residualColumn >= 0) {
      residual = values[residualColumn];
    }
  }

  /** Adds the present step to the curves. */
  void sampleCurves() {
    sampleCurves(control.time());
  }

  private void sampleCurves(double time) {
    if (control.steps() > 0) {
      curves.add(
          System.currentTimeMillis(),
          time,
          control.stepSize(),
          control.order(),
          energyDrift,
          residual);
    }
  }

  /** Returns the curves of step size, order, energy drift and residual, oldest sample first. */
  List<CurveSample> curves() {
    return curves.samples();
  }

  /** Refuses further rows: a solver that outlasts its run adds nothing to the results. */
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
