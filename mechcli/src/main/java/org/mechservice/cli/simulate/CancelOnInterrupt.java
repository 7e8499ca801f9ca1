package org.mechservice.cli.simulate;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Makes Ctrl-C and a termination signal cancel the run and then wait until the rows so far are in
 * their files.
 */
public final class CancelOnInterrupt implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(CancelOnInterrupt.class);
  private static final long LONGEST_WAIT_SECONDS = 20;

  private final CountDownLatch finished = new CountDownLatch(1);
  private final Thread hook = new Thread(this::interrupted, "cancel-on-interrupt");
  private volatile Optional<Runnable> cancel = Optional.empty();
  private volatile boolean setUp;
  private volatile boolean interrupted;

  public CancelOnInterrupt() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Names the run to cancel, which is set up now. */
  void cancelsRun(PreparedRun run) {
    setUp = true;
    cancels(run::cancel);
  }

  /** Returns whether the process was interrupted before there was a run. */
  boolean endsSetUp() {
    return interrupted && !setUp;
  }

  /** Sets the action that cancels. */
  public void cancels(Runnable how) {
    cancel = Optional.of(how);
  }

  private void interrupted() {
    interrupted = true;
    if (cancel.isEmpty()) {
      return;
    }
    try {
      cancel.get().run();
      if (!finished.await(LONGEST_WAIT_SECONDS, TimeUnit.SECONDS)) {
        LOG.warn(
            MessageCode.RUN_STOPPED + " the run did not stop within {} s", LONGEST_WAIT_SECONDS);
      }
    } catch (ServiceException e) {
      LOG.warn("{}", e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Permits the end of the process: the rows are complete. */
  @Override
  public void close() {
    finished.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      LOG.debug("the process is already on its way out", e);
    }
  }
}
