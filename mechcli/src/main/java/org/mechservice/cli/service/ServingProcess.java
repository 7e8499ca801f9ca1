package org.mechservice.cli.service;

import org.mechservice.cli.shell.LogSetup;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps a serving process going, and ends it in bounded time on a termination signal. */
public final class ServingProcess {
  private static final Logger LOG = LoggerFactory.getLogger(ServingProcess.class);

  /** Longest time for the orderly close; after it, the process ends whatever hangs, ms. */
  private static final long CLOSING_MILLIS = 15_000;

  /** Exit status of a process that ends on a termination signal: 128 + 15. */
  private static final int TERMINATED = 143;

  /** Waits until a process has ended by itself. */
  public interface Wait {
    void await() throws InterruptedException;
  }

  private ServingProcess() {}

  /**
   * Waits until the process has ended by itself, closing it on Ctrl-C or a termination signal; its
   * log tells from then on the causes of what fails.
   *
   * @param process closed on a signal
   * @param end returns when the process has ended
   */
  public static void untilEnded(AutoCloseable process, Wait end) throws InterruptedException {
    untilEnded(process, 0, end);
  }

  /**
   * Waits until the process has ended by itself, stopping it on Ctrl-C or a termination signal.
   *
   * @param stop called on a signal; returns when the process may end
   * @param graceSeconds longest time that {@code stop} waits for active runs before it closes, s
   * @param end returns when the process has ended
   */
  static void untilEnded(AutoCloseable stop, long graceSeconds, Wait end)
      throws InterruptedException {
    LogSetup.showCauses();
    Thread hook = new Thread(() -> close(stop, graceSeconds), "close-on-signal");
    Runtime.getRuntime().addShutdownHook(hook);
    try {
      end.await();
    } finally {
      forget(hook);
    }
  }

  private static void close(AutoCloseable stop, long graceSeconds) {
    haltAfter(graceSeconds * 1000 + CLOSING_MILLIS);
    try {
      stop.close();
    } catch (Exception e) {
      LOG.warn(MessageCode.UNCLEAN_CLOSE + " the process did not close in order: {}", e.toString());
    }
  }

  private static void haltAfter(long millis) {
    Thread watch =
        new Thread(
            () -> {
              try {
                Thread.sleep(millis);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
              }
              LOG.warn(
                  MessageCode.UNCLEAN_CLOSE
                      + " the process did not close in order: not closed within {} s",
                  millis / 1000);
              Runtime.getRuntime().halt(TERMINATED);
            },
            "halt-after-signal");
    watch.setDaemon(true);
    watch.start();
  }

  private static void forget(Thread hook) {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      LOG.debug("the process is already on its way out", e);
    }
  }
}
