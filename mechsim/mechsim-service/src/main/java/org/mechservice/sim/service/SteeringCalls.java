package org.mechservice.sim.service;

import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.solver.api.RunControl;

/**
 * How clients hold a run and let it go on.
 *
 * @param run the run
 * @param control of its solver
 */
record SteeringCalls(SimulationRun run, RunControl control) {
  private static final long HOLD_CHECK_MILLIS = 20;

  /** Holds the run after its current step. */
  void pause() throws InvalidState, InterruptedException {
    run.phase().requireStarted("paused");
    control.pause();
    awaitHeld();
  }

  /** Lets the run go on to its end. */
  void resume() throws InvalidState {
    run.phase().requireStarted("resumed");
    control.resume();
  }

  /** Takes one accepted step, starting the run if need be, and holds it again. */
  void stepOnce() throws InvalidState, LimitExceeded, InterruptedException {
    control.step();
    run.startIfNew();
    awaitHeld();
  }

  /** Lets the run go on, starting it if need be, until a step reaches a time, s. */
  void runTo(double time) throws InvalidState, LimitExceeded {
    if (!Double.isFinite(time)) {
      throw Refusal.state(run.state(), "runTo needs a finite time; " + time + " is none");
    }
    control.resumeTo(time);
    run.startIfNew();
  }

  private void awaitHeld() throws InterruptedException {
    long slices = MAX_WAIT_MILLIS.value / HOLD_CHECK_MILLIS;
    for (long i = 0; i < slices && !run.ended(); i++) {
      if (control.awaitHeld(HOLD_CHECK_MILLIS)) {
        return;
      }
    }
  }
}
