package org.mechservice.client.failure;

import org.mechservice.idl.SimState;

/** Where a simulation is in its life. */
public enum RunState {
  /** Ready to start. */
  CREATED,
  /** Waiting for room on the host. */
  QUEUED,
  /** Computing. */
  RUNNING,
  /** Held after a step until it is told to go on. */
  PAUSED,
  /** Reached its end. */
  DONE,
  /** Could not go on. */
  FAILED,
  /** Stopped on request. */
  CANCELLED;

  public static RunState of(SimState state) {
    return values()[state.value()];
  }

  /** Returns whether no further row will come. */
  public boolean ended() {
    return this == DONE || this == FAILED || this == CANCELLED;
  }
}
