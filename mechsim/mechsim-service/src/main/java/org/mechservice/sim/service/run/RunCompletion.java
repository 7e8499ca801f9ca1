package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.mechservice.idl.SimState;
import org.mechservice.sim.service.limits.LimitReachedException;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunFiles;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.text.FileErrors;

/**
 * Ends a run exactly once and stores its outcome.
 *
 * <p>A run that is done or has failed is on disk before its end is announced. The end of a
 * cancelled run is announced at once and written afterwards, so that a cancel waits neither for the
 * solver nor for the disk. Thread-safe.
 */
final class RunCompletion {
  private final Parts parts;
  private final RunStore store;
  private final RunFiles files;
  private final Consumer<String> notStored;
  private Optional<RunOutcome> outcome = Optional.empty();
  private Optional<LimitReachedException> limitReached = Optional.empty();
  private Future<?> stored = CompletableFuture.completedFuture(null);
  private boolean destroyed;
  private boolean left;

  /**
   * The parts of the run that its end concerns.
   *
   * @param simId its id
   */
  record Parts(
      String simId,
      RunLifecycle lifecycle,
      RunOutput output,
      RunStatus status,
      RunControl control) {}

  /**
   * @param notStored receives the reason if a cancelled run, whose end is announced already, cannot
   *     be written to disk
   */
  RunCompletion(Parts parts, RunStore store, RunFiles files, Consumer<String> notStored) {
    this.parts = parts;
    this.store = store;
    this.files = files;
    this.notStored = notStored;
  }

  /** Returns how the run ended; empty if it has not, or never began. */
  synchronized Optional<RunOutcome> outcome() {
    return outcome;
  }

  /** Returns the record of the run. */
  RunRecord record() {
    return parts.status().record(outcome());
  }

  /** Writes to disk that the run has begun. */
  void begun() throws IOException {
    files.writeBegun(record());
  }

  /** Notes that the run is stopped because it has reached a limit. */
  synchronized void stoppedAt(LimitReachedException limit) {
    limitReached = Optional.of(limit);
  }

  /** Returns whether the run has reached a limit. */
  synchronized boolean isAtLimit() {
    return limitReached.isPresent();
  }

  /** Ends a run that has not begun; returns false if it has. */
  synchronized boolean cancelUnbegun() {
    if (!parts.lifecycle().cancelUnbegun()) {
      return false;
    }
    release();
    return true;
  }

  /** Ends the run with the outcome of its computation. */
  void computed(RunOutcome result) {
    freeze();
    RunOutcome seen = withLimit(result);
    if (seen.state() == SimState.SIM_CANCELLED) {
      announceThenStore(seen);
    } else {
      announce(onDisk(seen));
    }
  }

  /** Ends the run as cancelled; its thread may still compute. */
  void cancelled() {
    freeze();
    announceThenStore(withLimit(RunOutcome.CANCELLED));
  }

  /** Freezes the run's rows and its clock. */
  private void freeze() {
    parts.output().close();
    parts.lifecycle().stopClock();
  }

  private synchronized RunOutcome withLimit(RunOutcome result) {
    return limitReached.map(limit -> result.stoppedAt(limit, parts.control())).orElse(result);
  }

  /** Returns the outcome after writing it to disk: failed if it cannot be written. */
  private RunOutcome onDisk(RunOutcome result) {
    try {
      files.writeEnded(parts.status().record(Optional.of(result)));
      return result;
    } catch (IOException e) {
      return result.failed(e, parts.control());
    }
  }

  private synchronized void announceThenStore(RunOutcome end) {
    if (announce(end) && files.lasts() && !destroyed) {
      stored = store.soon(parts.simId(), () -> storeFinal(end));
    }
  }

  private void storeFinal(RunOutcome end) {
    try {
      files.writeFinal(() -> parts.status().record(Optional.of(end)));
    } catch (IOException e) {
      notStored.accept(FileErrors.reason(e));
    }
  }

  private synchronized boolean announce(RunOutcome end) {
    if (parts.lifecycle().ended()) {
      return false;
    }
    outcome = Optional.of(end);
    store.count(end.state());
    // In this order: a client that has read the last row finds the state and events of the end.
    parts.lifecycle().end(end.state(), end.text(parts.output().lastTime()));
    release();
    return true;
  }

  private void release() {
    parts.output().spool().end();
    if (destroyed) {
      delete();
    } else if (left) {
      keep();
    }
  }

  /** Waits until a cancelled run is on disk, or the time is over. */
  void awaitDisk(long millis) throws InterruptedException {
    Future<?> pending;
    synchronized (this) {
      pending = stored;
    }
    try {
      pending.get(millis, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return; // the disk thread finishes later
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Deletes the run's rows and files, as soon as it has ended. */
  synchronized void destroy() {
    destroyed = true;
    if (parts.lifecycle().ended()) {
      delete();
    }
  }

  /** Keeps the run's rows for the retention time, as soon as it has ended. */
  synchronized void leave() {
    left = true;
    if (parts.lifecycle().ended()) {
      keep();
    }
  }

  private boolean hasBegun() {
    return parts.lifecycle().startedAt() != 0;
  }

  private void delete() {
    if (hasBegun()) {
      store.remember(record());
    }
    deleteFiles();
  }

  private void keep() {
    if (hasBegun()) {
      store.keep(record(), spool());
    } else {
      deleteFiles();
    }
  }

  private void deleteFiles() {
    store.delete(files, spool(), parts.simId());
  }

  private ResultSpool spool() {
    return parts.output().spool();
  }
}
