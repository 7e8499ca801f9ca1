package org.mechservice.guard.worker;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.mechservice.guard.Confinement;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Ends a process that does not answer in time, or whose caller is interrupted meanwhile: a thread
 * that reads from a process cannot be woken up otherwise. Thread-safe.
 */
final class Patience implements AutoCloseable {
  private static final long LOOK_MILLIS = 20;

  private static final ScheduledThreadPoolExecutor LOOKING =
      new ScheduledThreadPoolExecutor(
          1,
          task -> {
            Thread thread = new Thread(task, "mechservice-worker-patience");
            thread.setDaemon(true);
            return thread;
          });

  static {
    LOOKING.setRemoveOnCancelPolicy(true);
  }

  private final Process process;
  private final Duration longest;
  private final String what;
  private final String advice;
  private final ScheduledFuture<?> looks;
  private Optional<Thread> caller = Optional.empty();
  private long since;
  private Optional<String> ended = Optional.empty();

  /**
   * @param longest time of an answer
   * @param what is waited for, such as {@code the step of a run}
   * @param advice for an answer that takes longer
   */
  Patience(Process process, Duration longest, String what, String advice) {
    this.process = process;
    this.longest = longest;
    this.what = what;
    this.advice = advice;
    looks =
        LOOKING.scheduleWithFixedDelay(this::look, LOOK_MILLIS, LOOK_MILLIS, TimeUnit.MILLISECONDS);
  }

  /** Begins an answer that this thread waits for. */
  synchronized void begin() {
    since = System.nanoTime();
    caller = Optional.of(Thread.currentThread());
  }

  /** Ends it. */
  synchronized void end() {
    caller = Optional.empty();
  }

  private synchronized void look() {
    if (caller.isEmpty() || ended.isPresent()) {
      return;
    }
    if (caller.get().isInterrupted()) {
      ended = Optional.of("the thread that waited for " + what + " was interrupted.");
    } else if (System.nanoTime() - since > longest.toNanos()) {
      ended = Optional.of(what + " has taken more than " + longest.toSeconds() + " s.");
    }
    if (ended.isPresent()) {
      Confinement.end(process);
    }
  }

  /** Returns why the process was ended from here; empty if it was not. */
  synchronized Optional<WorkerLostException> ended() {
    return ended.map(why -> new WorkerLostException(MessageCode.WORKER_ENDED, why, advice));
  }

  /** Looks no longer. */
  @Override
  public void close() {
    looks.cancel(false);
  }
}
