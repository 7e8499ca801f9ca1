package org.mechservice.client.run;

import java.io.IOException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.RunControl;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A run at a server under the control of a program: what the program asks of its {@link RunControl}
 * reaches the server, and the progress of the run reaches the control. A thread compares both every
 * 50 ms while the rows arrive.
 */
public final class ControlledRun {
  private static final Logger LOG = LoggerFactory.getLogger(ControlledRun.class);
  private static final long LOOK_MILLIS = 50;

  private final RemoteRun run;
  private final RunControl control;
  private volatile boolean ended;

  /** Puts a run that is not started under a control. */
  public ControlledRun(RemoteRun run, RunControl control) {
    this.run = run;
    this.control = control;
  }

  /**
   * Runs to the end, as {@link RemoteRun#toEnd} does, or until the control stops it.
   *
   * @throws IOException if the sink or the store throws it
   * @throws ServiceException if the server is lost or refuses the run
   */
  public RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException {
    Thread watcher = new Thread(this::watch, "mechclient-control");
    watcher.setDaemon(true);
    watcher.start();
    try {
      return run.toEnd(sink, store);
    } finally {
      ended = true;
      watcher.interrupt();
    }
  }

  private void watch() {
    try {
      while (!ended && !control.stopRequested()) {
        compare(run.progress());
        Thread.sleep(LOOK_MILLIS);
      }
      if (!ended) {
        run.cancel();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ServiceException e) {
      LOG.debug("the run is no longer controlled; whoever takes its rows hears why", e);
    }
  }

  /** Shows the control how far the run is, and pauses the run as long as the control asks. */
  private void compare(RunProgress reached) {
    double size = reached.stepSize();
    int order = reached.order();
    long steps = reached.steps();
    if (Double.isNaN(reached.time()) || steps == 0) {
      return;
    }
    if (!control.holdsAt(reached.time(), size, order, steps)) {
      control.proceed(reached.time(), size, order, steps);
      return;
    }
    run.pause();
    if (control.proceed(reached.time(), size, order, steps)) {
      run.resume();
    }
  }
}
