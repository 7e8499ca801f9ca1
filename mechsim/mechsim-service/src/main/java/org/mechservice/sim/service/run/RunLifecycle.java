package org.mechservice.sim.service.run;

import org.mechservice.idl.InvalidState;
import org.mechservice.idl.SimState;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.solver.api.run.RunControl;

/**
 * The state machine of one run, with the times at which it begins and ends.
 *
 * <p>A run is created, queued, running, and then done, failed or cancelled; it never goes back, and
 * it ends once. Thread-safe.
 */
final class RunLifecycle {
  /** Receives each change of state, in the thread that makes it; must not block. */
  interface Listener {
    void stateChanged(SimState state, String text);
  }

  private final RunControl control;
  private final Listener listener;
  private SimState phase = SimState.SIM_CREATED;
  private String text = "";
  private boolean holdReported;
  private long startedAt;
  private long endedAt;
  private long startedNanos;
  private long endedNanos;

  /**
   * @param control of the solver; it knows whether the run is held
   */
  RunLifecycle(RunControl control, Listener listener) {
    this.control = control;
    this.listener = listener;
  }

  /** Returns the state; a run that is held is paused. */
  synchronized SimState state() {
    return phase == SimState.SIM_RUNNING && control.held() ? SimState.SIM_PAUSED : phase;
  }

  /** Returns the text of the latest change of state. */
  synchronized String text() {
    return text;
  }

  /** Returns whether the run has not been started. */
  synchronized boolean isNew() {
    return phase == SimState.SIM_CREATED;
  }

  /** Returns whether the run waits for a place. */
  synchronized boolean waits() {
    return phase == SimState.SIM_QUEUED;
  }

  /** Returns whether the run has begun and not ended; it may be held. */
  synchronized boolean runs() {
    return phase == SimState.SIM_RUNNING;
  }

  /** Returns whether the run is done, failed or cancelled. */
  synchronized boolean ended() {
    return phase == SimState.SIM_DONE
        || phase == SimState.SIM_FAILED
        || phase == SimState.SIM_CANCELLED;
  }

  /** Returns when the run began, UTC, ms since 1970-01-01; 0 if it has not. */
  synchronized long startedAt() {
    return startedAt;
  }

  /** Returns when the run ended, UTC, ms since 1970-01-01; 0 if it has not. */
  synchronized long endedAt() {
    return endedAt;
  }

  /** Returns the wall time between the start and the end, or now if the run has not ended, s. */
  synchronized double wallSeconds() {
    long end = endedAt == 0 ? System.nanoTime() : endedNanos;
    return startedAt == 0 ? 0 : (end - startedNanos) * 1e-9;
  }

  /**
   * Makes sure that the run was started and has not ended.
   *
   * @param what the client wants done to it, as a participle
   * @throws InvalidState if the run was not started or has ended
   */
  synchronized void requireStarted(String what) throws InvalidState {
    if (isNew()) {
      throw ContractErrors.state(
          phase, "the simulation has not been started: it cannot be " + what);
    }
    if (ended()) {
      throw ContractErrors.state(phase, "the simulation has ended: it cannot be " + what);
    }
  }

  /**
   * Puts a new run among those that wait.
   *
   * @throws InvalidState if the run was started before
   */
  synchronized void queue() throws InvalidState {
    if (!isNew()) {
      throw ContractErrors.state(state(), "the simulation was started before; create another one");
    }
    become(SimState.SIM_QUEUED, "waiting for a place");
  }

  /** Begins a waiting run; returns false if it has ended meanwhile. */
  synchronized boolean begin() {
    if (!waits()) {
      return false;
    }
    startedAt = System.currentTimeMillis();
    startedNanos = System.nanoTime();
    become(SimState.SIM_RUNNING, "running");
    return true;
  }

  /** Ends a run that has not begun; returns false if it has. */
  synchronized boolean cancelUnbegun() {
    if (!isNew() && !waits()) {
      return false;
    }
    end(SimState.SIM_CANCELLED, "cancelled before it began");
    return true;
  }

  /** Records the time of the end; the first call counts. */
  synchronized void stopClock() {
    if (endedAt == 0) {
      endedAt = System.currentTimeMillis();
      endedNanos = System.nanoTime();
    }
  }

  /** Ends the run, which must not have ended before. */
  synchronized void end(SimState end, String how) {
    stopClock();
    become(end, how);
    notifyAll();
  }

  private void become(SimState next, String how) {
    phase = next;
    text = how;
    listener.stateChanged(next, how);
  }

  /** Notifies the listener if the run was held, or released, since the previous call. */
  synchronized void reportHold() {
    boolean held = state() == SimState.SIM_PAUSED;
    if (runs() && held != holdReported) {
      holdReported = held;
      text = held ? "paused at t=" + control.time() + " s" : "running";
      listener.stateChanged(state(), text);
    }
  }

  /**
   * Waits for the end of the run.
   *
   * @param millis longest wait, ms
   * @return whether the run has ended
   */
  synchronized boolean awaitEnd(long millis) throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    for (long wait = millis; !ended() && wait > 0; ) {
      wait(wait);
      wait = (deadline - System.nanoTime()) / 1_000_000;
    }
    return ended();
  }
}
