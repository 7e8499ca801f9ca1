package org.mechservice.client.sweep;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.solver.api.result.Variable;

/**
 * Runs a model at every point of a grid, with as many runs at once as the hosts of the server have
 * places. Each run has the same bits as a single run. A run that is lost with its host or the
 * connection is repeated on another host; a run that fails numerically is a row with the reason.
 */
public final class Sweep {
  /** Interval between queries of the number of places. */
  private static final long GROWTH_MILLIS = 2000;

  /** Largest number of attempts for a point that is lost with its host. */
  private static final int ATTEMPTS = 4;

  private final MechConnection connection;
  private final Path model;
  private final Optional<Path> userCode;
  private final SimulationOptions options;
  private final SweepGrid grid;
  private final int atMost;

  private final Deque<Integer> waiting = new ArrayDeque<>();
  private final List<Thread> workers = new ArrayList<>();
  private final Set<RemoteRun> running = ConcurrentHashMap.newKeySet();
  private int unfinished;
  private boolean stopped;
  private @Nullable Exception fatal;
  private @Nullable ServiceException lastLoss;

  /**
   * @param model MechML file
   * @param userCode folder of classes that are not beside the file
   * @param options options of every run, without the parameters of the grid
   * @param atMost largest number of runs at once
   */
  public Sweep(
      MechConnection connection,
      Path model,
      Optional<Path> userCode,
      SimulationOptions options,
      SweepGrid grid,
      int atMost) {
    this.connection = connection;
    this.model = model;
    this.userCode = userCode;
    this.options = options;
    this.grid = grid;
    this.atMost = atMost;
  }

  /**
   * Runs until every point is finished.
   *
   * @param done points to leave out
   * @param listener receives the rows of all other points
   * @throws IOException if the model cannot be read, or the listener ended the sweep
   * @throws ServiceException if the model or an option cannot be used, the model has no parameter
   *     of such a name, or no host is left
   * @throws InterruptedException if the thread is interrupted; all runs are cancelled then
   */
  public void run(Set<Integer> done, SweepListener listener)
      throws IOException, InterruptedException {
    MechSession first = connection.openSession();
    try {
      List<ModelMessage> warnings = first.loadModel(model, userCode);
      List<Variable> columns;
      try (RemoteRun asInFile = first.prepareRemoteRun(options)) {
        columns = asInFile.columns();
      }
      listener.begins(warnings, columns);
    } catch (IOException | RuntimeException e) {
      first.close();
      throw e;
    }
    synchronized (this) {
      for (int point = 0; point < grid.size(); point++) {
        if (!done.contains(point)) {
          waiting.addLast(point);
        }
      }
      unfinished = waiting.size();
    }
    begin(Optional.of(first), listener);
    try {
      growUntilDone(listener);
    } finally {
      stop();
      awaitWorkers();
    }
    rethrow();
  }

  private synchronized void begin(Optional<MechSession> session, SweepListener listener) {
    Thread worker =
        new Thread(() -> work(session, listener), "mechservice-sweep-" + workers.size());
    worker.setDaemon(true);
    workers.add(worker);
    worker.start();
  }

  private void growUntilDone(SweepListener listener) throws InterruptedException {
    while (goesOn()) {
      int places = Math.min(atMost, places());
      synchronized (this) {
        for (int alive = alive(); alive < Math.min(places, unfinished); alive++) {
          begin(Optional.empty(), listener);
        }
        if (goesOn()) {
          wait(GROWTH_MILLIS);
        }
      }
    }
  }

  /** Returns whether points and threads are left. */
  private synchronized boolean goesOn() {
    return unfinished > 0 && !stopped && (alive() > 0 || lastLoss == null);
  }

  private int alive() {
    return (int) workers.stream().filter(Thread::isAlive).count();
  }

  private int places() {
    try {
      return Math.max(1, connection.places());
    } catch (ServiceException e) {
      return 1; // the threads notice a lost server
    }
  }

  /**
   * Starts no further run and cancels those in progress; {@link #run} then returns. May be called
   * from any thread.
   */
  public void stop() {
    synchronized (this) {
      stopped = true;
      waiting.clear();
      notifyAll();
    }
    for (RemoteRun run : running) {
      try {
        run.cancel();
      } catch (ServiceException e) {
        // It is lost, which ends it too.
      }
    }
  }

  private void awaitWorkers() throws InterruptedException {
    List<Thread> all;
    synchronized (this) {
      all = List.copyOf(workers);
    }
    for (Thread worker : all) {
      worker.join();
    }
  }

  private synchronized void rethrow() throws IOException {
    if (fatal instanceof IOException e) {
      throw e;
    } else if (fatal instanceof RuntimeException e) {
      throw e;
    } else if (unfinished > 0 && lastLoss != null) {
      throw lastLoss;
    }
  }

  private synchronized Optional<Integer> next() {
    return stopped ? Optional.empty() : Optional.ofNullable(waiting.pollFirst());
  }

  private synchronized void again(int point) {
    if (!stopped) {
      waiting.addFirst(point);
    }
  }

  private void work(Optional<MechSession> opened, SweepListener listener) {
    try (PointRunner runner = new PointRunner(this, opened)) {
      for (Optional<Integer> point = next(); point.isPresent(); point = next()) {
        finishOrGiveBack(runner, point.get(), listener);
      }
    } catch (ServiceException e) {
      synchronized (this) {
        lastLoss = e;
      }
    } catch (IOException | RuntimeException e) {
      synchronized (this) {
        fatal = e;
      }
      stop();
    } finally {
      synchronized (this) {
        notifyAll();
      }
    }
  }

  private void finishOrGiveBack(PointRunner runner, int point, SweepListener listener)
      throws IOException {
    Optional<SweepRow> row = Optional.empty();
    try {
      row = runner.run(point, ATTEMPTS);
    } finally {
      if (row.isEmpty()) {
        again(point);
      }
    }
    if (row.isPresent()) {
      finished(row.get(), listener);
    }
  }

  private synchronized void finished(SweepRow row, SweepListener listener) throws IOException {
    if (stopped && row.outcome().equals(SweepRow.STOPPED)) {
      return; // by us
    }
    unfinished--;
    lastLoss = null;
    listener.finished(row, running.size());
  }

  MechSession session() throws IOException {
    MechSession session = connection.openSession();
    try {
      session.loadModel(model, userCode);
      return session;
    } catch (IOException | RuntimeException e) {
      session.close();
      throw e;
    }
  }

  /** Prepares the run of a point, which is cancelled if the sweep is stopped. */
  RemoteRun prepare(MechSession session, int point) {
    SimulationOptions here = options;
    for (Map.Entry<String, String> value : grid.point(point).entrySet()) {
      here = here.parameter(value.getKey(), value.getValue());
    }
    RemoteRun run = session.prepareRemoteRun(here);
    running.add(run);
    if (isStopped()) {
      run.cancel(); // it was not among those that were cancelled then
    }
    return run;
  }

  void ended(RemoteRun run) {
    running.remove(run);
  }

  synchronized boolean isStopped() {
    return stopped;
  }
}
