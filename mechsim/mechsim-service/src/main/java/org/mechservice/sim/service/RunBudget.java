package org.mechservice.sim.service;

import java.util.Locale;
import java.util.Optional;

/**
 * What time a run has taken. Asked from time to time by the clock of its host, which ends the run
 * when it is more than allowed.
 */
final class RunBudget {
  private static final double SECOND = 1e-9;

  private final RunTask task;
  private long askedAt = System.nanoTime();
  private long busyNanos;

  /** Begins to count. */
  RunBudget(RunTask task) {
    this.task = task;
  }

  /**
   * Returns the limit that is reached, if one is.
   *
   * @param held whether the run is paused, which costs it nothing
   */
  synchronized Optional<RunLimitException> exceeded(HostLimits limits, boolean held) {
    long now = System.nanoTime();
    if (!held) {
      busyNanos += now - askedAt;
    }
    askedAt = now;
    double cpu = Math.max(0, task.cpuNanos()) * SECOND;
    if (busyNanos * SECOND > limits.bound(HostLimit.WALL_TIME)) {
      return over(HostLimit.WALL_TIME, "time", limits);
    } else if (cpu > limits.bound(HostLimit.CPU_TIME)) {
      return over(HostLimit.CPU_TIME, "processor time", limits);
    }
    return Optional.empty();
  }

  private static Optional<RunLimitException> over(HostLimit limit, String what, HostLimits limits) {
    return Optional.of(
        new RunLimitException(
            limit,
            String.format(
                Locale.ROOT,
                "the run has used up the %d s of %s that this host allows one run",
                limits.of(limit),
                what)));
  }
}
