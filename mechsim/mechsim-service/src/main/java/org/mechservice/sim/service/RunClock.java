package org.mechservice.sim.service;

/** When a run began and ended. Thread-safe. */
final class RunClock {
  private long startedAt;
  private long endedAt;
  private long startedNanos;
  private long endedNanos;

  synchronized void start() {
    startedAt = System.currentTimeMillis();
    startedNanos = System.nanoTime();
  }

  /** Notes the end; the first one counts. */
  synchronized void end() {
    if (endedAt == 0) {
      endedAt = System.currentTimeMillis();
      endedNanos = System.nanoTime();
    }
  }

  /** Returns when the run began, UTC, ms since 1970-01-01; 0 if it has not. */
  synchronized long startedAt() {
    return startedAt;
  }

  /** Returns when the run ended, UTC, ms since 1970-01-01; 0 if it has not. */
  synchronized long endedAt() {
    return endedAt;
  }

  /** Returns how long the run has been going on, or went on, s. */
  synchronized double wallSeconds() {
    long end = endedAt == 0 ? System.nanoTime() : endedNanos;
    return startedAt == 0 ? 0 : (end - startedNanos) * 1e-9;
  }
}
