package org.mechservice.benchmarks.suite;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Processor time of the thread that creates it, against a limit. */
final class Deadline {
  /** Reading the processor time costs as much as several evaluations. */
  private static final int LOOK_EVERY = 256;

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private final long began = THREADS.getCurrentThreadCpuTime();
  private final double limit;
  private int asked;
  private boolean over;

  /**
   * @param limit s from now
   */
  Deadline(double limit) {
    this.limit = limit;
  }

  /** Returns whether the time is over, as of the last look. */
  boolean isOver() {
    if (asked++ % LOOK_EVERY == 0) {
      over = seconds() > limit;
    }
    return over;
  }

  /** Returns the processor time spent, s. */
  double seconds() {
    return (THREADS.getCurrentThreadCpuTime() - began) * 1e-9;
  }

  /** Returns the cause of a run that was stopped. */
  String cause() {
    return String.format(java.util.Locale.ROOT, "not finished within %.3g s", limit);
  }
}
