package org.mechservice.sim.service;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.solver.api.Failure;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.TunableParameter;
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

  /** How long who asks for the state waits for the end of a step. */
  private static final long STATE_MILLIS = 500;

  private final RunPlan plan;
  private final RunQueue queue;
  private final RunStore store;
  private final Listener listener;
  private final ResultSpool spool;
  private final RunControl control = new RunControl();
  private final RunCurves curves = new RunCurves();
  private final RunColumnsWatch watch;
  private final double[] lastState;
  private final Object stateWatch = new Object();

  private RunTask task;
  private final Map<String, String> parameters = new TreeMap<>();
  private SimState phase = SimState.SIM_CREATED;
  private double lastTime;
  private String text = "";
  private long startedAt;
  private long endedAt;
  private long startedNanos;
  private long endedNanos;
  private @Nullable RunBudget budget;
  private @Nullable RunLimitException limitReached;
  private Optional<RunVerdict> verdict = Optional.empty();
  private boolean destroyed;
  private boolean left;
  private boolean holdTold;
  private long stepsTold = -1;

  SimulationRun(RunPlan plan, RunQueue queue, RunStore store, Listener listener) {
    this.plan = plan;
    this.queue = queue;
    this.store = store;
    this.listener = listener;
    spool = store.newRows(plan.identity().simId(), plan.columns().count());
    watch = new RunColumnsWatch(plan.columns());
    lastState = new double[plan.task().description().stateCount()];
    lastTime = settings().tStart();
    task = plan.task();
    task.initialState(lastState);
    task.checkpointsOfRun().ifPresent(checkpoints -> checkpoints.countRowsWith(spool::rows));
  }

  String simId() {
    return plan.identity().simId();
  }

  RunIdentity identity() {
    return plan.identity();
  }

  RunColumns columns() {
    return plan.columns();
  }

  ResultSpool spool() {
    return spool;
  }

  List<Variable> states() {
    return plan.task().description().states();
  }

  /** Returns its checkpoints; empty if it can have none. */
  Optional<RunCheckpoints> checkpoints() {
    return task().checkpointsOfRun().filter(RunCheckpoints::possible);
  }

  private synchronized RunTask task() {
    return task;
  }

  /** Returns the parameters that may be set before the start, with the values they have. */
  List<TunableParameter> parameters() {
    return task().parameters();
  }

  /**
   * Sets parameters; those set before stay.
   *
   * @throws InvalidState if the run was started
   * @throws IllegalArgumentException S-125 if one of them cannot be set, S-126 if its value cannot
   *     be used; then none is
   */
  synchronized void setParameters(Map<String, String> values) throws InvalidState {
    if (phase != SimState.SIM_CREATED) {
      throw Refusal.state(
          state(), "parameters are set before the start; create another simulation");
    }
    Map<String, String> all = new TreeMap<>(parameters);
    all.putAll(values);
    task = plan.task().with(all);
    task.initialState(lastState);
    parameters.putAll(values);
  }

  private RunSettings settings() {
    return plan.task().settings();
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

  /**
   * Lets the run begin as soon as there is room.
   *
   * @throws LimitExceeded if too many wait already
   */
  synchronized void start() throws InvalidState, LimitExceeded {
    if (phase != SimState.SIM_CREATED) {
      throw Refusal.state(state(), "the simulation was started before; create another one");
    }
    queue.requireRoom();
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
  void stepOnce() throws InvalidState, LimitExceeded, InterruptedException {
    control.step();
    startIfNew();
    awaitHeld();
  }

  /** Lets the run go on, starting it if need be, until a step reaches a time, s. */
  void runTo(double time) throws InvalidState, LimitExceeded {
    if (!Double.isFinite(time)) {
      throw Refusal.state(state(), "runTo needs a finite time; " + time + " is none");
    }
    control.resumeTo(time);
    startIfNew();
  }

  private synchronized void startIfNew() throws InvalidState, LimitExceeded {
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
        giveUp();
      }
    }
  }

  private void giveUp() {
    if (startedAt != 0) {
      store.delete(afterwards(), spool);
    } else {
      spool.delete();
    }
  }

  /** Ends the run like {@link #destroy}, but what it has put out is kept for a while. */
  void leave() {
    cancel();
    synchronized (this) {
      if (ended() && startedAt != 0) {
        store.keep(afterwards(), spool);
      } else if (ended()) {
        spool.delete();
      } else {
        left = true;
      }
    }
  }

  /** Ends the run if it has used up what a run may use. */
  synchronized void checkLimits(HostLimits limits) {
    if (budget != null && phase == SimState.SIM_RUNNING && limitReached == null) {
      budget
          .exceeded(limits, control.held())
          .ifPresent(
              limit -> {
                limitReached = limit;
                control.stop();
              });
    }
  }

  @Override
  public void run() {
    synchronized (this) {
      if (ended()) {
        return;
      }
      startedAt = System.currentTimeMillis();
      startedNanos = System.nanoTime();
      budget = new RunBudget(task);
      become(SimState.SIM_RUNNING, "running");
    }
    RunVerdict result = kept(compute());
    synchronized (this) {
      verdict = Optional.of(result);
      finish(result.state(), result.text(lastTime));
    }
  }

  private RunVerdict compute() {
    try {
      store.began(afterwards());
    } catch (IOException e) {
      return new RunVerdict(Optional.empty(), new Outcome.Stopped()).failed(e, control);
    }
    RunVerdict result = RunVerdict.of(task(), simId(), this, control);
    synchronized (this) {
      endedAt = System.currentTimeMillis();
      endedNanos = System.nanoTime();
      return limitReached == null ? result : result.stoppedAt(limitReached, control);
    }
  }

  /** A run has not ended well before its rows and its report are where they shall stay. */
  private RunVerdict kept(RunVerdict result) {
    try {
      store.ended(afterwards(result), spool);
      return result;
    } catch (IOException e) {
      return result.failed(e, control);
    }
  }

  private void finish(SimState end, String how) {
    if (endedAt == 0) {
      endedAt = System.currentTimeMillis();
      endedNanos = System.nanoTime();
    }
    // In this order: who has read the last row finds the state and the events of the end.
    become(end, how);
    spool.end();
    if (destroyed) {
      giveUp();
    } else if (left) {
      store.keep(afterwards(), spool);
    }
  }

  private void become(SimState next, String how) {
    phase = next;
    text = how;
    listener.stateChanged(this, next, how);
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
    watch.row(values);
    spool.append(values);
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

  /** Returns the report as JSON; empty until the run has ended, and if it never began. */
  synchronized Optional<String> report() {
    return verdict.map(this::report);
  }

  private String report(RunVerdict result) {
    return plan.facts().json(result.report().orElseGet(this::brokenOff), result);
  }

  private Map<String, Object> brokenOff() {
    Map<String, Object> map = new LinkedHashMap<>();
    map.put("scene", plan.identity().modelName());
    map.put("outcome", "failed");
    map.put("formulation", plan.task().description().formulation());
    map.put("integrator", settings().integrator());
    map.put("relativeTolerance", settings().relativeTolerance());
    map.put("absoluteTolerance", settings().absoluteTolerance());
    map.put("steps", control.steps());
    map.put("rows", spool.rows());
    map.put("simulatedTime", reached() - settings().tStart());
    map.put("wallTime", wallSeconds());
    return map;
  }

  private double reached() {
    return Double.isNaN(control.time()) ? settings().tStart() : control.time();
  }

  private double wallSeconds() {
    long end = endedNanos == 0 ? System.nanoTime() : endedNanos;
    return startedNanos == 0 ? 0 : (end - startedNanos) * 1e-9;
  }

  /** Returns why the run failed, if it did. */
  synchronized Optional<Failure> failure() {
    return verdict.flatMap(RunVerdict::failure);
  }

  /** Returns what is left of the run but its rows. */
  synchronized EndedRun afterwards() {
    return afterwards(null);
  }

  private synchronized EndedRun afterwards(@Nullable RunVerdict result) {
    Progress last = progress();
    Optional<RunVerdict> known = result == null ? verdict : Optional.of(result);
    known.ifPresent(ended -> last.state = ended.state());
    return new EndedRun(
        plan.identity(),
        plan.columns(),
        states(),
        last,
        startedAt,
        endedAt,
        known.map(ended -> ended.text(lastTime)).orElse(text),
        known.map(this::report).orElse(""),
        known.flatMap(RunVerdict::failure).map(Wire::failure),
        curves.all());
  }

  /** Returns how far the run is. */
  synchronized Progress progress() {
    double start = settings().tStart();
    double wall = wallSeconds();
    return new Progress(
        simId(),
        state(),
        phase == SimState.SIM_QUEUED ? queue.positionOf(this) : 0,
        reached(),
        start,
        settings().tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        wall > 0 ? (reached() - start) / wall : 0,
        spool.rows());
  }

  /**
   * Returns it as administrators see it.
   *
   * @param leaseEnd when its session's lease ends; UTC, ms since 1970-01-01
   */
  synchronized SimSummary summary(long leaseEnd) {
    RunIdentity who = plan.identity();
    return new SimSummary(
        who.simId(),
        who.sessionId(),
        who.hostName(),
        who.modelName(),
        who.owner(),
        progress(),
        who.createdAt(),
        startedAt,
        endedAt,
        leaseEnd,
        text);
  }

  /** Tells the listener if the run was held, or let go, since it was told last. */
  synchronized void tellHold() {
    boolean held = state() == SimState.SIM_PAUSED;
    if (phase == SimState.SIM_RUNNING && held != holdTold) {
      holdTold = held;
      text = held ? "paused at t=" + control.time() + " s" : "running";
      listener.stateChanged(this, state(), text);
    }
  }

  /** Returns whether the run has got on since this was asked last. */
  synchronized boolean hasProgressed() {
    long steps = control.steps();
    boolean progressed = phase == SimState.SIM_RUNNING && steps != stepsTold;
    stepsTold = steps;
    if (progressed) {
      curves.sample(control, watch.energyDrift(), watch.residual());
    }
    return progressed;
  }
}
