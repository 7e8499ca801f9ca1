package org.mechservice.sim.service.limits;

import java.io.IOException;

/** A run has reached a limit; it ends, and its rows so far are kept. */
public final class LimitReachedException extends IOException {
  private static final long serialVersionUID = 1L;

  private final HostLimit limit;

  LimitReachedException(HostLimit limit, String message) {
    super(message);
    this.limit = limit;
  }

  public HostLimit limit() {
    return limit;
  }
}
