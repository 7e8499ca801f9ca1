package org.mechservice.sim.service;

import java.io.IOException;

/** A run has reached a limit and ends; the rows so far are kept. */
final class RunLimitException extends IOException {
  private static final long serialVersionUID = 1L;

  private final HostLimit limit;

  RunLimitException(HostLimit limit, String message) {
    super(message);
    this.limit = limit;
  }

  HostLimit limit() {
    return limit;
  }
}
