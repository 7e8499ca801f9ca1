package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.LowPriority;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.limits.TimeBudget;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One simulation from its creation to its end: runs once, in a thread of the {@link RunQueue}, and
 * leaves its rows in a {@link ResultSpool}. Thread-safe.
 */
public final class SimulationRun implements Runnable {
  /** Receives what happens to a run, in the thread that causes it; must not block. */
  public interface Listener {
    void stateChanged(SimulationRun run, SimState state, String text);

    /** The run, whose end was announced before, could not be written to disk. */
    void notOnDisk(SimulationRun run, String why);
  }

  private static final Logger LOG = LoggerFactory.getLogger(SimulationRun.class);

  /**
   * Longest wait of a cancel for the solver, ms; the solver looks at its control at every
   * evaluation. An evaluation or a factorisation that takes longer keeps running, and its result is
   * dropped.
   */
  private static final long SOLVER_MILLIS = 30;

  /** Longest wait of a cancel for the disk, after that for the solver, ms. */
  private static final long DISK_MILLIS = 20;

  private static final long HOLD_CHECK_MILLIS = 20;
  private static final long CHECKPOINT_CHECK_MILLIS = 5;

  private final RunPlan plan;
  private final RunQueue queue;
  private final RunControl control = new RunControl();
  private final RunLifecycle lifecycle;
  private final RunOutput output;
  private final RunStatus status;
  private final RunCompletion completion;
  private RunTask task;
  private final Map<String, String> parameters = new TreeMap<>();
  private volatile @Nullable TimeBudget budget;
  private volatile boolean computing;
  private volatile long begunAt;

  /** The thread that computes, while its priority is the usual one. */
  private volatile OptionalLong thread = OptionalLong.empty();

  SimulationRun(RunPlan plan, RunQueue queue, RunStore store, Listener listener) {
    this.plan = plan;
    this.queue = queue;
    ResultSpool spool =
        store.newRows(plan.identity().simId(), plan.identity().owner(), plan.columns().count());
    task = plan.task();
    lifecycle =
        new RunLifecycle(control, (state, text) -> listener.stateChanged(this, state, text));
    output = new RunOutput(task, plan.columns(), spool, control);
    status = new RunStatus(plan, () -> queue.positionOf(this), control, lifecycle, output);
    completion =
        new RunCompletion(
            new RunCompletion.Parts(simId(), lifecycle, output, status, control),
            store,
            store.files(simId(), spool),
            why -> listener.notOnDisk(this, why));
    task.checkpoints().countRowsWith(spool::rows);
  }

  public String simId() {
    return plan.identity().simId();
  }

  public RunIdentity identity() {
    return plan.identity();
  }

  public RunColumns columns() {
    return plan.columns();
  }

  public ResultSpool spool() {
    return output.spool();
  }

  public List<Variable> states() {
    return plan.task().description().states();
  }

  private synchronized RunTask task() {
    return task;
  }

  /** Returns the parameters that may be set before the start, with the values they have. */
  public List<TunableParameter> parameters() {
    return task().parameters();
  }

  /**
   * Sets parameters; those set before stay.
   *
   * @throws InvalidState if the run was started
   * @throws IllegalArgumentException S-125 if one of them cannot be set, S-126 if its value cannot
   *     be used; then none is
   */
  public synchronized void setParameters(Map<String, String> values) throws InvalidState {
    if (!lifecycle.isNew()) {
      throw ContractErrors.state(
          state(), "parameters are set before the start; create another simulation");
    }
    Map<String, String> all = new TreeMap<>(parameters);
    all.putAll(values);
    task = plan.task().with(all);
    output.startFrom(task);
    parameters.putAll(values);
  }

  /** Returns the state; a run that is held is paused. */
  public SimState state() {
    return lifecycle.state();
  }

  /** Returns whether the run is done, failed or cancelled. */
  public boolean ended() {
    return lifecycle.ended();
  }

  /**
   * Puts the run into the queue; it begins as soon as there is a place.
   *
   * @throws InvalidState if it was started before
   * @throws LimitExceeded if too many runs wait already
   */
  public synchronized void start() throws InvalidState, LimitExceeded {
    if (lifecycle.isNew()) {
      queue.requireRoom(plan.identity().owner());
    }
    lifecycle.queue();
    queue.submit(plan.identity().owner(), this);
  }

  private synchronized void startIfNew() throws InvalidState, LimitExceeded {
    if (lifecycle.isNew()) {
      start();
    } else {
      lifecycle.requireStarted("continued");
    }
  }

  /**
   * Holds the run after its current step, and waits until it is held.
   *
   * @throws InvalidState if it was not started or has ended
   */
  public void pause() throws InvalidState, InterruptedException {
    lifecycle.requireStarted("paused");
    control.pause();
    awaitHeld();
  }

  /**
   * Releases a held run, which then computes to its end.
   *
   * @throws InvalidState if it was not started or has ended
   */
  public void resume() throws InvalidState {
    lifecycle.requireStarted("resumed");
    control.resume();
  }

  /**
   * Takes one accepted step and holds the run again; starts a new run.
   *
   * @throws InvalidState if it has ended
   * @throws LimitExceeded if too many runs wait already
   */
  public void stepOnce() throws InvalidState, LimitExceeded, InterruptedException {
    control.step();
    startIfNew();
    awaitHeld();
  }

  /**
   * Computes until a step reaches a time, then holds the run; starts a new run.
   *
   * @param time simulated time, s
   * @throws InvalidState if it has ended, or the time is not finite
   * @throws LimitExceeded if too many runs wait already
   */
  public void runTo(double time) throws InvalidState, LimitExceeded {
    if (!Double.isFinite(time)) {
      throw ContractErrors.state(state(), "runTo needs a finite time; " + time + " is none");
    }
    control.resumeTo(time);
    startIfNew();
  }

  private void awaitHeld() throws InterruptedException {
    long slices = MAX_WAIT_MILLIS.value / HOLD_CHECK_MILLIS;
    for (long i = 0; i < slices && !ended(); i++) {
      if (control.awaitHeld(HOLD_CHECK_MILLIS)) {
        return;
      }
    }
  }

  /** Returns whether the run can be saved in a checkpoint. */
  public boolean canBeSaved() {
    return task().checkpoints().possible();
  }

  private RunCheckpoints requireCheckpoints() throws NotAvailable {
    RunCheckpoints checkpoints = task().checkpoints();
    if (!checkpoints.possible()) {
      throw new NotAvailable(
          MessageCode.MODEL_CANNOT_BE_SAVED.code(),
          "a run of the model cannot be saved: its loops do not tell their state");
    }
    return checkpoints;
  }

  /**
   * Makes a checkpoint after the current step; a cancelled run has left one, unless its last step
   * took longer than a call may wait.
   *
   * @throws InvalidState if there is nothing to save yet or any more, or the run takes no step
   * @throws NotAvailable if the run cannot be saved
   */
  public byte[] checkpoint() throws InvalidState, NotAvailable, InterruptedException {
    RunCheckpoints checkpoints = requireCheckpoints();
    if (state() == SimState.SIM_CREATED || state() == SimState.SIM_QUEUED) {
      throw ContractErrors.state(state(), "the simulation has not begun: there is nothing to save");
    }
    long request = checkpoints.request();
    long slices = MAX_WAIT_MILLIS.value / CHECKPOINT_CHECK_MILLIS;
    for (long i = 0; i < slices && !checkpoints.answers(request) && !takesNoStep(); i++) {
      Thread.sleep(CHECKPOINT_CHECK_MILLIS);
    }
    Optional<byte[]> found =
        checkpoints.answers(request) || isSavedWhereItStands(checkpoints)
            ? checkpoints.latest()
            : Optional.empty();
    return found.orElseThrow(
        () ->
            ContractErrors.state(
                state(),
                ended()
                    ? "the simulation has ended: there is no checkpoint of it"
                    : "the simulation takes no step just now; it is saved after its next one"));
  }

  private boolean takesNoStep() {
    return (ended() && !computing) || state() == SimState.SIM_PAUSED;
  }

  private boolean isSavedWhereItStands(RunCheckpoints checkpoints) {
    return ended() || (state() == SimState.SIM_PAUSED && checkpoints.isWithoutRowsSince());
  }

  /**
   * Sets the checkpoint that the run starts from; whether it fits shows when the run is started.
   *
   * @throws InvalidState if the run was started before
   * @throws NotAvailable if the run cannot be saved
   */
  public void restore(byte[] checkpoint) throws InvalidState, NotAvailable {
    if (state() != SimState.SIM_CREATED) {
      throw ContractErrors.state(state(), "the simulation was started before; create another one");
    }
    requireCheckpoints().startFrom(checkpoint);
  }

  /** Stops the run within one evaluation; one that has not begun never will. Idempotent. */
  public void stop() {
    control.stop();
    if (completion.cancelUnbegun()) {
      queue.withdraw(this);
    }
  }

  /**
   * Stops the run after its current step, so that it leaves a checkpoint, or within one evaluation
   * if the step takes long; when this returns, it has ended, with the rows it had put out. Waits
   * neither for a solver within one long evaluation nor for a disk that does not answer.
   * Idempotent.
   */
  public void cancel() throws InterruptedException {
    if (lifecycle.runs() && canBeSaved()) {
      control.stopAfterStep(MAX_WAIT_MILLIS.value, this::ended);
    }
    end();
    completion.awaitDisk(DISK_MILLIS);
  }

  /** Stops the run; when this returns, it has ended, and may not be on disk yet. Idempotent. */
  public void end() throws InterruptedException {
    stop();
    if (!lifecycle.awaitEnd(SOLVER_MILLIS)) {
      completion.cancelled();
    }
  }

  /** Stops the run and deletes its rows as soon as its thread writes no more of them. */
  public void destroy() {
    stop();
    completion.destroy();
  }

  /** Stops the run and keeps its rows for the retention time. */
  public void leave() {
    stop();
    completion.leave();
  }

  /** Stops the run if it has used up its time. */
  public void checkLimits(HostLimits limits) {
    TimeBudget used = budget;
    if (used != null && lifecycle.runs() && !completion.isAtLimit()) {
      used.exceeded(limits, control.held())
          .ifPresent(
              limit -> {
                completion.stoppedAt(limit);
                control.stop();
              });
    }
  }

  /** Writes the rows so far to where they outlive the process; the run itself reports failures. */
  public void handOverRows() {
    try {
      spool().handOver();
    } catch (IOException e) {
      LOG.debug("rows of run {} stay in memory", simId(), e);
    }
  }

  @Override
  public void run() {
    if (lifecycle.begin()) {
      RunTask begun = task();
      budget = new TimeBudget(begun::cpuNanos);
      completion.computed(computeBegun(begun));
    }
  }

  /** Lets runs of others come first if this one has computed for long; called again and again. */
  public void yieldToOthers() {
    OptionalLong id = thread;
    if (computing && id.isPresent() && LowPriority.isDue(begunAt)) {
      thread = OptionalLong.empty();
      LowPriority.lowerThread(id.getAsLong());
      task().lowerPriority();
    }
  }

  private RunOutcome computeBegun(RunTask begun) {
    try {
      completion.begun();
    } catch (IOException e) {
      return RunOutcome.CANCELLED.failed(e, control);
    }
    begunAt = System.nanoTime();
    thread = LowPriority.idOfThisThread();
    computing = true;
    try {
      return RunOutcome.of(begun.run(output, control));
    } catch (IOException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
      return RunOutcome.ofException(e, simId(), control);
    } finally {
      computing = false;
    }
  }

  /**
   * Returns the state reached, as {@link RunOutput#lastState} does.
   *
   * @param time simulated time at 0, s; overwritten
   */
  public double[] lastState(double[] time) throws InterruptedException {
    return output.lastState(time);
  }

  /** Returns the report as JSON; empty until the run has ended, and if it never began. */
  public Optional<String> report() {
    return completion.outcome().map(status::report);
  }

  /** Returns why the run failed, if it did. */
  public Optional<Failure> failure() {
    return completion.outcome().flatMap(RunOutcome::failure);
  }

  /** Returns the record of the run. */
  public RunRecord record() {
    return completion.record();
  }

  /** Returns how far the run is. */
  public Progress progress() {
    return status.progress();
  }

  /**
   * Returns the run as administrators see it.
   *
   * @param leaseEnd when its session's lease ends; UTC, ms since 1970-01-01
   */
  public SimSummary summary(long leaseEnd) {
    return status.summary(leaseEnd);
  }

  /** Notifies the listener if the run was held, or released, since the previous call. */
  public void reportHold() {
    lifecycle.reportHold();
  }

  /** Returns whether the run has taken a step, or moved up in the queue, since the last call. */
  public boolean hasProgressed() {
    return status.hasProgressed();
  }
}
