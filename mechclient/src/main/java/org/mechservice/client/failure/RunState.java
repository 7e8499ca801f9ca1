package org.mechservice.client.failure;

import org.mechservice.idl.SimState;

/** State of a simulation. */
public enum RunState {
  /** Ready to start. */
  CREATED,
  /** Waiting for a free place on the host. */
  QUEUED,
  /** Computing. */
  RUNNING,
  /** Paused after a step until it is resumed. */
  PAUSED,
  /** Reached its end. */
  DONE,
  /** Could not continue. */
  FAILED,
  /** Stopped on request. */
  CANCELLED;

  public static RunState of(SimState state) {
    return values()[state.value()];
  }

  /** Returns whether the run has ended and no further row follows. */
  public boolean ended() {
    return this == DONE || this == FAILED || this == CANCELLED;
  }
}
