package org.mechservice.sim.service.run;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;

/** Runs simulations, as many at once as the host's capacity; the others wait in order. */
public final class RunQueue implements AutoCloseable {
  private final ThreadPoolExecutor threads;
  private final CurrentLimits limits;

  /**
   * @param capacity simulations at once
   */
  public RunQueue(int capacity, CurrentLimits limits) {
    this.limits = limits;
    threads =
        new ThreadPoolExecutor(
            Math.max(1, capacity),
            Math.max(1, capacity),
            1,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread thread = new Thread(task, "mechservice-run");
              thread.setDaemon(true);
              return thread;
            });
    threads.allowCoreThreadTimeOut(true);
  }

  /**
   * Makes sure that one more can wait.
   *
   * @throws LimitExceeded if too many wait already
   */
  void requireRoom() throws LimitExceeded {
    if (threads.getActiveCount() >= threads.getMaximumPoolSize()) {
      limits.now().requireBelow(HostLimit.QUEUE, threads.getQueue().size());
    }
  }

  void submit(Runnable run) {
    threads.execute(run);
  }

  /** Takes a run that still waits out of the queue; returns whether it was there. */
  boolean withdraw(Runnable run) {
    return threads.remove(run);
  }

  /** Returns the place of a waiting run, from 1; 0 if it does not wait. */
  int positionOf(Runnable run) {
    int position = 0;
    for (Runnable waiting : threads.getQueue()) {
      position++;
      if (waiting == run) {
        return position;
      }
    }
    return 0;
  }

  /** Takes no more runs; those there are must have been stopped. */
  @Override
  public void close() {
    threads.shutdown();
  }

  /** Waits until no run is left. */
  public void awaitEnd(long millis) throws InterruptedException {
    threads.awaitTermination(millis, TimeUnit.MILLISECONDS);
  }
}
