package org.mechservice.sim.service;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.mechservice.idl.SimState;
import org.mechservice.solver.api.Outcome;

/**
 * How a run ends, which it does once, and what becomes of it then. One that has come to its end or
 * has failed is said to have done so when that is on disk; one that is cancelled at once, and goes
 * to disk afterwards: who cancels waits neither for a solver nor for a disk. Thread-safe.
 */
final class RunConclusion {
  private final RunStory story;
  private final RunStore store;
  private final RunRecord record;
  private final Consumer<String> unkept;
  private Optional<RunVerdict> verdict = Optional.empty();
  private Optional<RunLimitException> limitReached = Optional.empty();
  private Future<?> settled = CompletableFuture.completedFuture(null);
  private boolean destroyed;
  private boolean left;

  /**
   * @param unkept hears why a cancelled run, whose end was told already, is not on disk
   */
  RunConclusion(RunStory story, RunStore store, RunRecord record, Consumer<String> unkept) {
    this.story = story;
    this.store = store;
    this.record = record;
    this.unkept = unkept;
  }

  /** Returns how the run ended; empty if it has not, or never began. */
  synchronized Optional<RunVerdict> verdict() {
    return verdict;
  }

  /** Returns what is left of the run but its rows. */
  EndedRun afterwards() {
    return story.afterwards(verdict());
  }

  /** Writes down that the run has begun. */
  void begun() throws IOException {
    record.begun(afterwards());
  }

  /** Takes note that the run is stopped because it has reached a limit. */
  synchronized void stoppedAt(RunLimitException limit) {
    limitReached = Optional.of(limit);
  }

  /** Returns whether the run has reached a limit. */
  synchronized boolean isAtLimit() {
    return limitReached.isPresent();
  }

  /** Ends a run that has not begun; returns false if it has. */
  synchronized boolean cancelUnbegun() {
    if (!story.phase().cancelUnbegun()) {
      return false;
    }
    close();
    return true;
  }

  /** Ends the run as its solver says. */
  void computed(RunVerdict result) {
    stand();
    RunVerdict seen = seen(result);
    if (seen.state() == SimState.SIM_CANCELLED) {
      tellAtOnce(seen);
    } else {
      tell(onDisk(seen));
    }
  }

  /** Ends the run as cancelled, whatever its own thread is at. */
  void cancelled() {
    stand();
    tellAtOnce(seen(new RunVerdict(Optional.empty(), new Outcome.Stopped())));
  }

  /** From here on nothing is added to what is said of the run. */
  private void stand() {
    story.rows().close();
    story.clock().end();
  }

  private synchronized RunVerdict seen(RunVerdict result) {
    return limitReached.map(limit -> result.stoppedAt(limit, story.control())).orElse(result);
  }

  /** A run has not ended well before its rows and its report are where they shall stay. */
  private RunVerdict onDisk(RunVerdict result) {
    try {
      record.ended(story.afterwards(Optional.of(result)));
      return result;
    } catch (IOException e) {
      return result.failed(e, story.control());
    }
  }

  private synchronized void tellAtOnce(RunVerdict end) {
    if (tell(end) && record.lasts() && !destroyed) {
      settled = store.soon(story.plan().identity().simId(), () -> settle(end));
    }
  }

  private void settle(RunVerdict end) {
    try {
      record.settle(() -> story.afterwards(Optional.of(end)));
    } catch (IOException e) {
      unkept.accept(FileTrouble.why(e));
    }
  }

  private synchronized boolean tell(RunVerdict end) {
    if (story.phase().ended()) {
      return false;
    }
    verdict = Optional.of(end);
    store.count(end.state());
    // In this order: who has read the last row finds the state and the events of the end.
    story.phase().end(end.state(), end.text(story.rows().lastTime()));
    close();
    return true;
  }

  private void close() {
    story.rows().spool().end();
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
      pending = settled;
    }
    try {
      pending.get(millis, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return; // it gets there without being waited for
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Lets nothing of the run stay, as soon as it has ended. */
  synchronized void destroy() {
    destroyed = true;
    if (story.phase().ended()) {
      delete();
    }
  }

  /** Lets what the run has put out be kept for a while, as soon as it has ended. */
  synchronized void leave() {
    left = true;
    if (story.phase().ended()) {
      keep();
    }
  }

  private boolean hasBegun() {
    return story.clock().startedAt() != 0;
  }

  private void delete() {
    if (hasBegun()) {
      store.remember(afterwards());
    }
    store.delete(record, story.rows().spool(), story.plan().identity().simId());
  }

  private void keep() {
    if (hasBegun()) {
      store.keep(afterwards(), story.rows().spool());
    } else {
      store.delete(record, story.rows().spool(), story.plan().identity().simId());
    }
  }
}
