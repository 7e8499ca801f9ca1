package org.mechservice.sim.service;

import org.mechservice.idl.InvalidState;
import org.mechservice.idl.SimState;
import org.mechservice.solver.api.RunControl;

/** How far a run is in its life. It goes forward only, and ends once. Thread-safe. */
final class RunPhase {
  /** Hears of changes of state, in the thread that makes them; must not block. */
  interface Listener {
    void stateChanged(SimState state, String text);
  }

  private final RunControl control;
  private final RunClock clock;
  private final Listener listener;
  private SimState phase = SimState.SIM_CREATED;
  private String text = "";
  private boolean holdTold;

  /**
   * @param control of the solver, which knows whether it is held
   * @param clock started and stopped here
   */
  RunPhase(RunControl control, RunClock clock, Listener listener) {
    this.control = control;
    this.clock = clock;
    this.listener = listener;
  }

  /** Returns the state; a run that is held is paused. */
  synchronized SimState state() {
    return phase == SimState.SIM_RUNNING && control.held() ? SimState.SIM_PAUSED : phase;
  }

  /** Returns what was said last of the state. */
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

  /** Returns whether the run has ended, one way or another. */
  synchronized boolean ended() {
    return phase == SimState.SIM_DONE
        || phase == SimState.SIM_FAILED
        || phase == SimState.SIM_CANCELLED;
  }

  /**
   * Makes sure that the run is under way.
   *
   * @param what is done to it, as a participle
   * @throws InvalidState if it was not started or has ended
   */
  synchronized void requireStarted(String what) throws InvalidState {
    if (isNew()) {
      throw Refusal.state(phase, "the simulation has not been started: it cannot be " + what);
    }
    if (ended()) {
      throw Refusal.state(phase, "the simulation has ended: it cannot be " + what);
    }
  }

  /** Lets a new run wait for its place. */
  synchronized void queue() throws InvalidState {
    if (!isNew()) {
      throw Refusal.state(state(), "the simulation was started before; create another one");
    }
    become(SimState.SIM_QUEUED, "waiting for a place");
  }

  /** Lets a waiting run begin; returns false if it has ended meanwhile. */
  synchronized boolean begin() {
    if (!waits()) {
      return false;
    }
    clock.start();
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

  /** Ends the run, which must not have ended before. */
  synchronized void end(SimState end, String how) {
    clock.end();
    become(end, how);
    notifyAll();
  }

  private void become(SimState next, String how) {
    phase = next;
    text = how;
    listener.stateChanged(next, how);
  }

  /** Tells the listener if the run was held, or let go, since it was told last. */
  synchronized void tellHold() {
    boolean held = state() == SimState.SIM_PAUSED;
    if (runs() && held != holdTold) {
      holdTold = held;
      text = held ? "paused at t=" + control.time() + " s" : "running";
      listener.stateChanged(state(), text);
    }
  }

  /** Waits for the end, or until the time is over; returns whether the run has ended. */
  synchronized boolean awaitEnd(long millis) throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    for (long wait = millis; !ended() && wait > 0; ) {
      wait(wait);
      wait = (deadline - System.nanoTime()) / 1_000_000;
    }
    return ended();
  }
}
