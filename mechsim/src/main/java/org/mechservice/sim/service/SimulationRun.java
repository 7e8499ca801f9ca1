package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.Variable;

/**
 * One simulation from its creation to its end: runs once, in a thread of the {@link RunQueue}, and
 * leaves its rows in a {@link ResultSpool}. Thread-safe.
 */
final class SimulationRun implements Runnable {
  /** Hears of changes of state, in the thread that makes them; must not block. */
  interface Listener {
    void stateChanged(SimulationRun run, SimState state, String text);
  }

  /**
   * How long who cancels waits for the solver, which looks at its control at every evaluation. An
   * evaluation or a factorisation that takes longer goes on for nobody.
   */
  private static final long CANCEL_MILLIS = 50;

  private final RunPlan plan;
  private final RunQueue queue;
  private final RunStore store;
  private final Listener listener;
  private final RunRows rows;
  private final RunControl control = new RunControl();
  private final RunCurves curves = new RunCurves();
  private final RunClock clock = new RunClock();

  private RunTask task;
  private final Map<String, String> parameters = new TreeMap<>();
  private SimState phase = SimState.SIM_CREATED;
  private String text = "";
  private @Nullable RunBudget budget;
  private @Nullable RunLimitException limitReached;
  private Optional<RunVerdict> verdict = Optional.empty();
  private boolean computing;
  private boolean concluded;
  private boolean destroyed;
  private boolean left;
  private boolean holdTold;
  private long stepsTold = -1;
  private int positionTold;

  SimulationRun(RunPlan plan, RunQueue queue, RunStore store, Listener listener) {
    this.plan = plan;
    this.queue = queue;
    this.store = store;
    this.listener = listener;
    ResultSpool spool = store.newRows(plan.identity().simId(), plan.columns().count());
    task = plan.task();
    rows = new RunRows(task, plan.columns(), spool, control);
    task.checkpoints().countRowsWith(spool::rows);
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
    return rows.spool();
  }

  List<Variable> states() {
    return plan.task().description().states();
  }

  /** Returns its checkpoints; empty if it can have none. */
  Optional<RunCheckpoints> checkpoints() {
    return Optional.of(task().checkpoints()).filter(RunCheckpoints::possible);
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
    rows.begin(task);
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

  /** Returns what clients hold it and let it go on with. */
  SteeringCalls steering() {
    return new SteeringCalls(this, control);
  }

  /**
   * Starts the run if it was not started before.
   *
   * @throws InvalidState if it has ended
   * @throws LimitExceeded if too many wait already
   */
  synchronized void startIfNew() throws InvalidState, LimitExceeded {
    if (phase == SimState.SIM_CREATED) {
      start();
    } else {
      requireStarted("continued");
    }
  }

  /**
   * Makes sure that the run is under way.
   *
   * @param what is done to it, as a participle
   * @throws InvalidState if it was not started or has ended
   */
  synchronized void requireStarted(String what) throws InvalidState {
    if (phase == SimState.SIM_CREATED) {
      throw Refusal.state(phase, "the simulation has not been started: it cannot be " + what);
    }
    if (ended()) {
      throw Refusal.state(phase, "the simulation has ended: it cannot be " + what);
    }
  }

  /** Stops the run within one evaluation; one that has not begun never will. Idempotent. */
  void stop() {
    control.stop();
    synchronized (this) {
      boolean waits = phase == SimState.SIM_QUEUED && queue.withdraw(this);
      if (phase == SimState.SIM_CREATED || waits) {
        finish(SimState.SIM_CANCELLED, "cancelled before it began");
      }
    }
  }

  /**
   * Stops the run; when this returns, it has ended, with the rows it had put out. A solver that is
   * deep in one evaluation is not waited for. Idempotent.
   */
  void cancel() throws InterruptedException {
    stop();
    if (!awaitEnd(CANCEL_MILLIS) && computes()) {
      conclude(new RunVerdict(Optional.empty(), new Outcome.Stopped()));
    }
    // What is left is to bring rows and report to disk.
    awaitEnd(MAX_WAIT_MILLIS.value);
  }

  private synchronized boolean awaitEnd(long millis) throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    long wait = millis;
    while (!ended() && wait > 0) {
      wait(wait);
      wait = (deadline - System.nanoTime()) / 1_000_000;
    }
    return ended();
  }

  /** Returns whether the solver is at work, if only to find that the run has ended meanwhile. */
  synchronized boolean computes() {
    return computing;
  }

  /** Stops the run and deletes its rows as soon as nobody writes them. */
  void destroy() {
    stop();
    synchronized (this) {
      destroyed = true;
      if (ended()) {
        giveUp();
      }
    }
  }

  private void giveUp() {
    if (clock.startedAt() != 0) {
      store.delete(afterwards(), spool());
    } else {
      spool().delete();
    }
  }

  /** Ends the run like {@link #destroy}, but what it has put out is kept for a while. */
  void leave() {
    stop();
    synchronized (this) {
      if (ended() && clock.startedAt() != 0) {
        store.keep(afterwards(), spool());
      } else if (ended()) {
        spool().delete();
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
      clock.start();
      budget = new RunBudget(task);
      become(SimState.SIM_RUNNING, "running");
    }
    conclude(compute());
  }

  private RunVerdict compute() {
    try {
      store.began(afterwards());
    } catch (IOException e) {
      return new RunVerdict(Optional.empty(), new Outcome.Stopped()).failed(e, control);
    }
    setComputing(true);
    try {
      return RunVerdict.of(task(), simId(), rows, control);
    } finally {
      setComputing(false);
    }
  }

  private synchronized void setComputing(boolean does) {
    computing = does;
  }

  /** Ends the run as its solver says, or as who cancels it says if the solver is late. */
  private void conclude(RunVerdict computed) {
    RunVerdict result;
    synchronized (this) {
      if (concluded) {
        return;
      }
      concluded = true;
      rows.close();
      clock.end();
      result = limitReached == null ? computed : computed.stoppedAt(limitReached, control);
    }
    RunVerdict kept = kept(result);
    synchronized (this) {
      verdict = Optional.of(kept);
      finish(kept.state(), kept.text(rows.lastTime()));
    }
  }

  /** A run has not ended well before its rows and its report are where they shall stay. */
  private RunVerdict kept(RunVerdict result) {
    try {
      store.ended(afterwards(result), spool());
      return result;
    } catch (IOException e) {
      return result.failed(e, control);
    }
  }

  private void finish(SimState end, String how) {
    clock.end();
    // In this order: who has read the last row finds the state and the events of the end.
    become(end, how);
    spool().end();
    if (destroyed) {
      giveUp();
    } else if (left) {
      store.keep(afterwards(), spool());
    }
    notifyAll();
  }

  private void become(SimState next, String how) {
    phase = next;
    text = how;
    listener.stateChanged(this, next, how);
  }

  /**
   * Returns the state reached, as {@link RunRows#lastState} does.
   *
   * @param time simulated time at 0, s; overwritten
   */
  double[] lastState(double[] time) throws InterruptedException {
    return rows.lastState(time);
  }

  /** Returns the report as JSON; empty until the run has ended, and if it never began. */
  synchronized Optional<String> report() {
    return verdict.map(this::report);
  }

  private String report(RunVerdict result) {
    return plan.facts().json(result.report().orElseGet(this::brokenOff), result);
  }

  private Map<String, Object> brokenOff() {
    return BrokenOffReport.of(plan, control, spool().rows(), clock.wallSeconds());
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
        clock.startedAt(),
        clock.endedAt(),
        known.map(ended -> ended.text(rows.lastTime())).orElse(text),
        known.map(this::report).orElse(""),
        known.flatMap(RunVerdict::failure).map(Wire::failure),
        curves.all());
  }

  /** Returns how far the run is. */
  synchronized Progress progress() {
    double start = settings().tStart();
    double wall = clock.wallSeconds();
    double reached = BrokenOffReport.timeReached(plan, control);
    return new Progress(
        simId(),
        state(),
        phase == SimState.SIM_QUEUED ? queue.positionOf(this) : 0,
        reached,
        start,
        settings().tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        wall > 0 ? (reached - start) / wall : 0,
        spool().rows());
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
        clock.startedAt(),
        clock.endedAt(),
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

  /** Returns whether the run has got on, or up in the queue, since this was asked last. */
  synchronized boolean hasProgressed() {
    int position = phase == SimState.SIM_QUEUED ? queue.positionOf(this) : 0;
    boolean movedUp = position > 0 && position != positionTold;
    positionTold = position;
    return movedUp || hasStepped();
  }

  private boolean hasStepped() {
    long steps = control.steps();
    boolean progressed = phase == SimState.SIM_RUNNING && steps != stepsTold;
    stepsTold = steps;
    if (progressed) {
      curves.sample(control, rows.watch().energyDrift(), rows.watch().residual());
    }
    return progressed;
  }
}
