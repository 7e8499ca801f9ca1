package org.mechservice.sim.service.limits;

import java.util.Locale;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * The wall time and the processor time that one run has used; the clock of its host checks them
 * against the limits from time to time.
 */
public final class TimeBudget {
  private static final double SECOND = 1e-9;

  private final LongSupplier cpuNanos;
  private long askedAt = System.nanoTime();
  private long busyNanos;

  /**
   * Begins to count.
   *
   * @param cpuNanos processor time of the run so far, ns; negative if it is not known
   */
  public TimeBudget(LongSupplier cpuNanos) {
    this.cpuNanos = cpuNanos;
  }

  /**
   * Returns the limit that is reached, if one is.
   *
   * @param held whether the run is paused, which costs it nothing
   */
  public synchronized Optional<LimitReachedException> exceeded(HostLimits limits, boolean held) {
    long now = System.nanoTime();
    if (!held) {
      busyNanos += now - askedAt;
    }
    askedAt = now;
    double cpu = Math.max(0, cpuNanos.getAsLong()) * SECOND;
    if (busyNanos * SECOND > limits.bound(HostLimit.WALL_TIME)) {
      return over(HostLimit.WALL_TIME, "time", limits);
    } else if (cpu > limits.bound(HostLimit.CPU_TIME)) {
      return over(HostLimit.CPU_TIME, "processor time", limits);
    }
    return Optional.empty();
  }

  private static Optional<LimitReachedException> over(
      HostLimit limit, String what, HostLimits limits) {
    return Optional.of(
        new LimitReachedException(
            limit,
            String.format(
                Locale.ROOT,
                "the run has used up the %d s of %s that this host allows one run",
                limits.of(limit),
                what)));
  }
}
