package org.mechservice.guard;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Ends a process that does not answer in time, or whose caller is interrupted meanwhile: a thread
 * that reads from a process cannot be woken up otherwise. A process that takes long has a lower
 * priority before. Thread-safe.
 */
public final class Patience implements AutoCloseable {
  private static final long LOOK_MILLIS = 50;

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
  private final ScheduledFuture<?> looks;
  private Optional<Thread> caller = Optional.empty();
  private long since;
  private boolean lowered;
  private Optional<String> ended = Optional.empty();

  /**
   * @param longest time of an answer
   * @param what is waited for, such as {@code a step}
   */
  public Patience(Process process, Duration longest, String what) {
    this.process = process;
    this.longest = longest;
    this.what = what;
    synchronized (this) {
      looks =
          LOOKING.scheduleWithFixedDelay(
              this::look, LOOK_MILLIS, LOOK_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  /** Begins an answer that this thread waits for. */
  public synchronized void begin() {
    since = System.nanoTime();
    caller = Optional.of(Thread.currentThread());
  }

  /** Ends it. */
  public synchronized void end() {
    caller = Optional.empty();
  }

  private synchronized void look() {
    if (!process.isAlive()) {
      close();
      return;
    }
    if (caller.isEmpty() || ended.isPresent()) {
      return;
    }
    if (caller.get().isInterrupted()) {
      ended = Optional.of("the thread that waited for " + what + " was interrupted.");
    } else if (System.nanoTime() - since > longest.toNanos()) {
      ended = Optional.of(what + " has taken more than " + longest.toSeconds() + " s.");
    }
    if (ended.isPresent()) {
      process.destroyForcibly();
    } else if (!lowered && LowPriority.isDue(since)) {
      lowered = true;
      LowPriority.lower(process.toHandle());
    }
  }

  /** Returns why the process was ended from here, as a sentence; empty if it was not. */
  public synchronized Optional<String> ended() {
    return ended;
  }

  /** Looks no longer. */
  @Override
  public synchronized void close() {
    looks.cancel(false);
  }
}
