package org.mechservice.cli.service;

import org.mechservice.cli.shell.LogSetup;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps a serving process going and closes it in order when a signal ends it. */
public final class ServingProcess {
  private static final Logger LOG = LoggerFactory.getLogger(ServingProcess.class);

  /** Waits for the end of a serving process. */
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
    LogSetup.showCauses();
    Thread hook = new Thread(() -> close(process), "close-on-signal");
    Runtime.getRuntime().addShutdownHook(hook);
    try {
      end.await();
    } finally {
      forget(hook);
    }
  }

  private static void close(AutoCloseable process) {
    try {
      process.close();
    } catch (Exception e) {
      LOG.warn(MessageCode.UNCLEAN_CLOSE + " the process did not close in order: {}", e.toString());
    }
  }

  private static void forget(Thread hook) {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      LOG.debug("the process is already on its way out", e);
    }
  }
}
