package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.solver.api.Failure;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.Variable;

/**
 * One simulation from its creation to its end: runs once, in a thread of the {@link RunQueue}, and
 * leaves its rows in a {@link ResultSpool}. Thread-safe.
 */
final class SimulationRun implements Runnable, ResultSink {
  /** Hears of changes of state, in the thread that makes them; must not block. */
  interface Listener {
    void stateChanged(SimulationRun run, SimState state, String text);
  }

  private static final long HOLD_CHECK_MILLIS = 20;

  private final String simId;
  private final Solver solver;
  private final Model model;
  private final RunRequest request;
  private final RunQueue queue;
  private final Listener listener;
  private final ResultSpool spool;
  private final RunControl control = new RunControl();

  private SimState phase = SimState.SIM_CREATED;
  private final double[] lastState;
  private double lastTime;
  private long startedAt;
  private long endedAt;
  private Optional<RunReport> report = Optional.empty();
  private boolean destroyed;
  private boolean holdTold;
  private long stepsTold = -1;

  /**
   * @param columns numbers per row
   */
  SimulationRun(
      String simId,
      Solver solver,
      Model model,
      RunRequest request,
      int columns,
      RunQueue queue,
      Listener listener) {
    this.simId = simId;
    this.solver = solver;
    this.model = model;
    this.request = request;
    this.queue = queue;
    this.listener = listener;
    spool = new ResultSpool(columns);
    lastState = new double[model.description().stateCount()];
    lastTime = request.settings().tStart();
    model.initialState(lastState);
  }

  String simId() {
    return simId;
  }

  ResultSpool spool() {
    return spool;
  }

  String modelName() {
    return model.description().name();
  }

  List<Variable> states() {
    return model.description().states();
  }

  /** Returns the state; a run that is held is paused. */
  synchronized SimState state() {
    return phase == SimState.SIM_RUNNING && control.held() ? SimState.SIM_PAUSED : phase;
  }

  /** Returns whether the run has ended, one way or another. */
  synchronized boolean ended() {
    return phase == SimState.SIM_DONE
        || phase == SimState.SIM_FAILED
        || phase == SimState.SIM_CANCELLED;
  }

  /** Lets the run begin as soon as there is room. */
  synchronized void start() throws InvalidState {
    if (phase != SimState.SIM_CREATED) {
      throw Refusal.state(state(), "the simulation was started before; create another one");
    }
    become(SimState.SIM_QUEUED, "waiting for a place");
    queue.submit(this);
  }

  /** Holds the run after its current step. */
  void pause() throws InvalidState, InterruptedException {
    requireStarted("paused");
    control.pause();
    awaitHeld();
  }

  /** Lets the run go on to its end. */
  void resume() throws InvalidState {
    requireStarted("resumed");
    control.resume();
  }

  /** Takes one accepted step, starting the run if need be, and holds it again. */
  void stepOnce() throws InvalidState, InterruptedException {
    control.step();
    startIfNew();
    awaitHeld();
  }

  /** Lets the run go on, starting it if need be, until a step reaches a time, s. */
  void runTo(double time) throws InvalidState {
    if (!Double.isFinite(time)) {
      throw Refusal.state(state(), "runTo needs a finite time; " + time + " is none");
    }
    control.resumeTo(time);
    startIfNew();
  }

  private synchronized void startIfNew() throws InvalidState {
    if (phase == SimState.SIM_CREATED) {
      start();
    } else {
      requireStarted("continued");
    }
  }

  private synchronized void requireStarted(String what) throws InvalidState {
    if (phase == SimState.SIM_CREATED) {
      throw Refusal.state(phase, "the simulation has not been started: it cannot be " + what);
    }
    if (ended()) {
      throw Refusal.state(phase, "the simulation has ended: it cannot be " + what);
    }
  }

  private void awaitHeld() throws InterruptedException {
    long slices = MAX_WAIT_MILLIS.value / HOLD_CHECK_MILLIS;
    for (long i = 0; i < slices && !ended(); i++) {
      if (control.awaitHeld(HOLD_CHECK_MILLIS)) {
        return;
      }
    }
  }

  /** Stops the run within one evaluation; one that has not begun never will. Idempotent. */
  void cancel() {
    control.stop();
    synchronized (this) {
      boolean waits = phase == SimState.SIM_QUEUED && queue.withdraw(this);
      if (phase == SimState.SIM_CREATED || waits) {
        finish(SimState.SIM_CANCELLED, "cancelled before it began");
      }
    }
  }

  /** Cancels the run and deletes its rows as soon as nobody writes them. */
  void destroy() {
    cancel();
    synchronized (this) {
      destroyed = true;
      if (ended()) {
        spool.close();
      }
    }
  }

  @Override
  public void run() {
    synchronized (this) {
      if (ended()) {
        return;
      }
      startedAt = System.nanoTime();
      become(SimState.SIM_RUNNING, "running");
    }
    RunReport result = solve();
    synchronized (this) {
      report = Optional.of(result);
      if (result.outcome() instanceof Outcome.Failed failed) {
        finish(SimState.SIM_FAILED, failed.failure().message());
      } else if (result.outcome() instanceof Outcome.Stopped) {
        finish(SimState.SIM_CANCELLED, "cancelled at t=" + result.timeReached() + " s");
      } else {
        finish(SimState.SIM_DONE, "done");
      }
    }
  }

  private RunReport solve() {
    try {
      return solver.run(model, request, this, control);
    } catch (IllegalArgumentException e) {
      return broken(coded("S-008", String.valueOf(e.getMessage())));
    } catch (IOException e) {
      return broken(coded("S-014", "the results cannot be kept: " + e.getMessage()));
    } catch (RuntimeException | OutOfMemoryError | StackOverflowError e) {
      String incident = GuardedServant.record("run " + simId, e);
      return broken(coded("S-001", "the server failed unexpectedly, incident " + incident));
    }
  }

  /** The solver's messages begin with their code; others get the code given here. */
  private Failure coded(String code, String message) {
    boolean hasCode = message.matches("(?s)[MNS]-\\d{3} .*");
    return new Failure(
        hasCode ? message.substring(0, 5) : code,
        hasCode ? message.substring(6) : message,
        lastTime(),
        control.stepSize(),
        control.order(),
        "",
        "");
  }

  private RunReport broken(Failure failure) {
    return new RunReport(
        new Outcome.Failed(failure),
        modelName(),
        model.description().formulation(),
        request.settings(),
        control.steps(),
        0,
        0,
        spool.rows(),
        lastTime(),
        (System.nanoTime() - startedAt()) * 1e-9,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        ServiceVersion.CURRENT);
  }

  private synchronized long startedAt() {
    return startedAt;
  }

  private void finish(SimState end, String text) {
    endedAt = System.nanoTime();
    // In this order: who has read the last row finds the state and the events of the end.
    become(end, text);
    spool.end();
    if (destroyed) {
      spool.close();
    }
  }

  private void become(SimState next, String text) {
    phase = next;
    listener.stateChanged(this, next, text);
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    if (columns.size() != spool.columns()) {
      throw new IOException(
          "the solver puts out " + columns.size() + " columns, expected " + spool.columns());
    }
  }

  @Override
  public void row(double[] values) throws IOException {
    synchronized (this) {
      lastTime = values[0];
      System.arraycopy(values, 1, lastState, 0, lastState.length);
    }
    spool.append(values);
  }

  /** Returns the time of the last row, or of the start, s. */
  synchronized double lastTime() {
    return lastTime;
  }

  /**
   * Returns the state of the last row, or of the start.
   *
   * @param time simulated time at 0, s; overwritten
   */
  synchronized double[] lastState(double[] time) {
    time[0] = lastTime;
    return lastState.clone();
  }

  /** Returns the report; empty until the run has ended, and if it never began. */
  synchronized Optional<RunReport> report() {
    return report;
  }

  /** Returns how far the run is. */
  synchronized Progress progress() {
    double start = request.settings().tStart();
    double reached = Double.isNaN(control.time()) ? start : control.time();
    double wall = startedAt == 0 ? 0 : ((ended() ? endedAt : System.nanoTime()) - startedAt) * 1e-9;
    return new Progress(
        simId,
        state(),
        phase == SimState.SIM_QUEUED ? queue.positionOf(this) : 0,
        reached,
        start,
        request.settings().tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        wall > 0 ? (reached - start) / wall : 0,
        spool.rows());
  }

  /** Tells the listener if the run was held, or let go, since it was told last. */
  synchronized void tellHold() {
    boolean held = state() == SimState.SIM_PAUSED;
    if (phase == SimState.SIM_RUNNING && held != holdTold) {
      holdTold = held;
      listener.stateChanged(
          this, state(), held ? "paused at t=" + control.time() + " s" : "running");
    }
  }

  /** Returns whether the run has got on since this was asked last. */
  synchronized boolean hasProgressed() {
    long steps = control.steps();
    boolean progressed = phase == SimState.SIM_RUNNING && steps != stepsTold;
    stepsTold = steps;
    return progressed;
  }
}
