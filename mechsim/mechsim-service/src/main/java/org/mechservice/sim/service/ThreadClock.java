package org.mechservice.sim.service;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** The processor time of the thread that started it. Thread-safe. */
final class ThreadClock {
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final long NOT_STARTED = -1;

  private volatile long threadId = NOT_STARTED;
  private volatile long atStart;

  /** Begins to count, for the thread that calls. */
  void start() {
    long id = Thread.currentThread().getId();
    atStart = now(id);
    threadId = id;
  }

  /** Returns the time since the start, ns; 0 before it, and where it cannot be measured. */
  long nanos() {
    long id = threadId;
    return id == NOT_STARTED ? 0 : Math.max(0, now(id) - atStart);
  }

  private static long now(long id) {
    return THREADS.isThreadCpuTimeSupported() ? THREADS.getThreadCpuTime(id) : 0;
  }
}
