package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.solver.api.Failure;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.Variable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One simulation from its creation to its end: runs once, in a thread of the {@link RunQueue}, and
 * leaves its rows in a {@link ResultSpool}. Thread-safe.
 */
final class SimulationRun implements Runnable {
  /** Hears of what becomes of a run, in the thread that makes it so; must not block. */
  interface Listener {
    void stateChanged(SimulationRun run, SimState state, String text);

    /** Hears that a run whose end was told before could not be written to disk. */
    void notOnDisk(SimulationRun run, String why);
  }

  private static final Logger LOG = LoggerFactory.getLogger(SimulationRun.class);

  /**
   * How long who cancels waits for the solver, which looks at its control at every evaluation. An
   * evaluation or a factorisation that takes longer goes on for nobody.
   */
  private static final long SOLVER_MILLIS = 30;

  /** How long who cancels waits then for the disk. */
  private static final long DISK_MILLIS = 20;

  private final RunPlan plan;
  private final RunQueue queue;
  private final RunControl control = new RunControl();
  private final RunPhase phase;
  private final RunRows rows;
  private final RunStory story;
  private final RunNews news;
  private final RunConclusion conclusion;

  private RunTask task;
  private final Map<String, String> parameters = new TreeMap<>();
  private volatile @Nullable RunBudget budget;
  private volatile boolean computing;

  SimulationRun(RunPlan plan, RunQueue queue, RunStore store, Listener listener) {
    this.plan = plan;
    this.queue = queue;
    ResultSpool spool = store.newRows(plan.identity().simId(), plan.columns().count());
    task = plan.task();
    RunClock clock = new RunClock();
    phase = new RunPhase(control, clock, (state, text) -> listener.stateChanged(this, state, text));
    rows = new RunRows(task, plan.columns(), spool, control);
    story = new RunStory(plan, queue, this, control, phase, clock, rows, new RunCurves());
    news = new RunNews(story);
    conclusion =
        new RunConclusion(
            story, store, store.record(simId(), spool), why -> listener.notOnDisk(this, why));
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
    if (!phase.isNew()) {
      throw Refusal.state(
          state(), "parameters are set before the start; create another simulation");
    }
    Map<String, String> all = new TreeMap<>(parameters);
    all.putAll(values);
    task = plan.task().with(all);
    rows.begin(task);
    parameters.putAll(values);
  }

  /** Returns the state; a run that is held is paused. */
  SimState state() {
    return phase.state();
  }

  /** Returns whether the run has ended, one way or another. */
  boolean ended() {
    return phase.ended();
  }

  /** Returns how far the run is in its life. */
  RunPhase phase() {
    return phase;
  }

  /**
   * Lets the run begin as soon as there is room.
   *
   * @throws LimitExceeded if too many wait already
   */
  synchronized void start() throws InvalidState, LimitExceeded {
    if (phase.isNew()) {
      queue.requireRoom();
    }
    phase.queue();
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
    if (phase.isNew()) {
      start();
    } else {
      phase.requireStarted("continued");
    }
  }

  /** Stops the run within one evaluation; one that has not begun never will. Idempotent. */
  void stop() {
    control.stop();
    if (conclusion.cancelUnbegun()) {
      queue.withdraw(this);
    }
  }

  /**
   * Stops the run; when this returns, it has ended, with the rows it had put out. Neither a solver
   * that is deep in one evaluation is waited for nor a disk that does not answer. Idempotent.
   */
  void cancel() throws InterruptedException {
    end();
    conclusion.awaitDisk(DISK_MILLIS);
  }

  /** Stops the run; when this returns, it has ended, and may not be on disk. Idempotent. */
  void end() throws InterruptedException {
    stop();
    if (!phase.awaitEnd(SOLVER_MILLIS)) {
      conclusion.cancelled();
    }
  }

  /** Returns whether the solver is at work, if only to find that the run has ended meanwhile. */
  boolean computes() {
    return computing;
  }

  /** Stops the run and deletes its rows as soon as nobody writes them. */
  void destroy() {
    stop();
    conclusion.destroy();
  }

  /** Ends the run like {@link #destroy}, but what it has put out is kept for a while. */
  void leave() {
    stop();
    conclusion.leave();
  }

  /** Ends the run if it has used up what a run may use. */
  void checkLimits(HostLimits limits) {
    RunBudget used = budget;
    if (used != null && phase.runs() && !conclusion.isAtLimit()) {
      used.exceeded(limits, control.held())
          .ifPresent(
              limit -> {
                conclusion.stoppedAt(limit);
                control.stop();
              });
    }
  }

  /**
   * Lets the rows so far outlive the process; what is wrong with that, the run finds out itself.
   */
  void handOverRows() {
    try {
      rows.spool().handOver();
    } catch (IOException e) {
      LOG.debug("rows of run {} stay in memory", simId(), e);
    }
  }

  @Override
  public void run() {
    if (phase.begin()) {
      RunTask begun = task();
      budget = new RunBudget(begun);
      conclusion.computed(compute(begun));
    }
  }

  private RunVerdict compute(RunTask begun) {
    try {
      conclusion.begun();
    } catch (IOException e) {
      return new RunVerdict(Optional.empty(), new Outcome.Stopped()).failed(e, control);
    }
    computing = true;
    try {
      return RunVerdict.of(begun, simId(), rows, control);
    } finally {
      computing = false;
    }
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
  Optional<String> report() {
    return conclusion.verdict().map(story::report);
  }

  /** Returns why the run failed, if it did. */
  Optional<Failure> failure() {
    return conclusion.verdict().flatMap(RunVerdict::failure);
  }

  /** Returns what is left of the run but its rows. */
  EndedRun afterwards() {
    return conclusion.afterwards();
  }

  /** Returns how far the run is. */
  Progress progress() {
    return story.progress();
  }

  /**
   * Returns it as administrators see it.
   *
   * @param leaseEnd when its session's lease ends; UTC, ms since 1970-01-01
   */
  SimSummary summary(long leaseEnd) {
    return story.summary(leaseEnd);
  }

  /** Tells the listener if the run was held, or let go, since it was told last. */
  void tellHold() {
    phase.tellHold();
  }

  /** Returns whether the run has got on, or up in the queue, since this was asked last. */
  boolean hasProgressed() {
    return news.any();
  }
}
