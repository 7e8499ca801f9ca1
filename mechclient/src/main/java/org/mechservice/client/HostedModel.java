package org.mechservice.client;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.NotFoundException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.api.result.ResultSink;

/**
 * A model that the hosts of a server run with many values of its parameters, for callers with
 * several threads. Each run has the same bits as a single run.
 *
 * <p>A run that is lost with its host is repeated on another one. While the server has fewer places
 * than there are threads, such as after the loss of a host, threads wait for the sessions of
 * others.
 *
 * <p>Thread-safe.
 */
public final class HostedModel implements AutoCloseable {
  private static final int ATTEMPTS = 5;
  private static final long PAUSE_MILLIS = 500;

  private final MechConnection connection;
  private final Path model;
  private final UserCode userCode;
  private final SimulationOptions options;
  private final Deque<MechSession> idle = new ArrayDeque<>();

  /** Sessions that are idle, in use or being opened. */
  private int open;

  private boolean closed;

  /**
   * @param model MechML file
   * @param userCode the folders whose classes are sent
   * @param options of every run; parameters that runs set as inputs are tunable in it
   */
  public HostedModel(
      MechConnection connection, Path model, UserCode userCode, SimulationOptions options) {
    this.connection = connection;
    this.model = model;
    this.userCode = userCode;
    this.options = options;
  }

  /**
   * Runs the model.
   *
   * @param settled values of parameters for which the model is generated, by name
   * @param inputs values of tunable parameters, by name
   * @param rows receives the rows; begins anew when a run is repeated
   * @throws IOException if the model cannot be read, or the sink throws it
   * @throws InvalidModelException if the model cannot be used
   * @throws InvalidOptionException if a value cannot be used
   * @throws ServiceException if no host runs it, after several attempts
   */
  public RunResult run(Map<String, String> settled, Map<String, String> inputs, ResultSink rows)
      throws IOException {
    for (int attempt = 1; ; attempt++) {
      MechSession session = take();
      boolean usable = false;
      try {
        RunResult result = runIn(session, settled, inputs, rows);
        usable = true;
        return result;
      } catch (InvalidModelException | InvalidOptionException e) {
        usable = true;
        throw e;
      } catch (ServerLostException | NotFoundException | LimitExceededException e) {
        if (attempt == ATTEMPTS) {
          throw e;
        }
      } finally {
        giveBack(session, usable);
      }
      pause(PAUSE_MILLIS * attempt);
    }
  }

  private RunResult runIn(
      MechSession session, Map<String, String> settled, Map<String, String> inputs, ResultSink rows)
      throws IOException {
    SimulationOptions here = options;
    for (Map.Entry<String, String> value : settled.entrySet()) {
      here = here.parameter(value.getKey(), value.getValue());
    }
    try (RemoteRun run = session.prepareRemoteRun(here)) {
      if (!inputs.isEmpty()) {
        run.setParameters(inputs);
      }
      return run.toEnd(rows);
    }
  }

  /** Returns an idle session, or opens one; waits while only others have sessions. */
  private MechSession take() throws IOException {
    for (int refusals = 0; ; ) {
      synchronized (this) {
        MechSession free = idle.pollFirst();
        if (free != null) {
          return free;
        }
        open++;
      }
      try {
        return opened();
      } catch (ServerLostException | NotFoundException | LimitExceededException e) {
        refusals++;
        if (!othersGoOn() && refusals >= ATTEMPTS) {
          throw e;
        }
        pause(PAUSE_MILLIS * Math.min(refusals, ATTEMPTS));
      }
    }
  }

  private MechSession opened() throws IOException {
    boolean done = false;
    try {
      MechSession session = connection.openSession();
      try {
        session.loadModel(model, userCode);
        done = true;
        return session;
      } finally {
        if (!done) {
          closeQuietly(session);
        }
      }
    } finally {
      if (!done) {
        forget();
      }
    }
  }

  private synchronized void forget() {
    open--;
  }

  private synchronized boolean othersGoOn() {
    return open > 0;
  }

  private void giveBack(MechSession session, boolean usable) {
    synchronized (this) {
      if (usable && !closed) {
        idle.addFirst(session);
        notifyAll();
        return;
      }
      open--;
    }
    closeQuietly(session);
  }

  /** Waits for a session that another thread gives back, or for a time. */
  private synchronized void pause(long millis) throws InterruptedIOException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    try {
      for (long left = millis; idle.isEmpty() && left > 0; ) {
        wait(left);
        left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while it waited for a place on a host");
    }
  }

  private static void closeQuietly(MechSession session) {
    try {
      session.close();
    } catch (ServiceException e) {
      // It is lost with its host.
    }
  }

  /** Closes the sessions; those in use are closed after their run. */
  @Override
  public void close() {
    Deque<MechSession> all;
    synchronized (this) {
      closed = true;
      all = new ArrayDeque<>(idle);
      open -= idle.size();
      idle.clear();
    }
    all.forEach(HostedModel::closeQuietly);
  }
}
