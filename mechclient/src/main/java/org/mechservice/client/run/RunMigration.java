package org.mechservice.client.run;

import java.util.Map;
import java.util.Optional;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServiceException;

/**
 * The move of a run to another host: the run is paused and saved on its host, and resumes from the
 * checkpoint on another host as soon as its earlier rows have been taken. The first host keeps the
 * run until then, so it can always continue there.
 */
final class RunMigration {
  private static final long BEGIN_MILLIS = 30_000;
  private static final long CHECK_MILLIS = 10;

  private final HostedRun from;
  private final HostedRun to;
  private final RunProgress held;

  private RunMigration(HostedRun from, HostedRun to, RunProgress held) {
    this.from = from;
    this.to = to;
    this.held = held;
  }

  /**
   * Pauses a run and passes its checkpoint to the new host.
   *
   * @param parameters parameters set before its start
   * @param until simulated time of the next pause, s; infinite for none
   * @return empty if the run cannot be saved at present; it then continues
   * @throws ServiceException if one of the hosts refuses; the run then continues on its host
   */
  static Optional<RunMigration> begin(
      HostedRun from, HostedRun to, Map<String, String> parameters, double until) {
    try {
      if (!parameters.isEmpty()) {
        to.setParameters(parameters);
      }
      from.calls().run(from.simulation()::pause);
      RunProgress held = from.progress();
      Optional<byte[]> saved =
          held.state() == RunState.PAUSED ? from.checkpoint() : Optional.empty();
      if (saved.isPresent() || held.state() == RunState.QUEUED) {
        saved.ifPresent(to::restore);
        return Optional.of(new RunMigration(from, to, held));
      }
      resumeAt(from, until);
      return Optional.empty();
    } catch (InvalidStateException e) {
      resumeAt(from, until);
      return Optional.empty();
    } catch (ServiceException e) {
      resumeAt(from, until);
      throw e;
    }
  }

  /** Resumes the run on its old host, unless it has ended there. */
  private static void resumeAt(HostedRun place, double until) {
    try {
      if (Double.isInfinite(until)) {
        place.calls().run(place.simulation()::resume);
      } else {
        place.calls().run(() -> place.simulation().runTo(until));
      }
    } catch (InvalidStateException e) {
      // It has ended: its rows contain the outcome.
      return;
    }
  }

  /** Returns the number of rows of the first host, all of which are taken there. */
  long rows() {
    return held.rows();
  }

  /** Returns the simulated time at which the run was paused, s. */
  double time() {
    return held.time();
  }

  HostedRun to() {
    return to;
  }

  /**
   * Resumes the run on the new host.
   *
   * @return false if it would have to wait there, or cannot be resumed
   */
  boolean resumeOnNewHost(double until) {
    if (Double.isInfinite(until)) {
      to.calls().run(to.simulation()::start);
    } else {
      to.calls().run(() -> to.simulation().runTo(until));
    }
    for (long i = 0; i < BEGIN_MILLIS / CHECK_MILLIS; i++) {
      RunProgress there = to.progress();
      boolean waits = there.state() == RunState.QUEUED && there.queuePosition() > 0;
      if (waits || there.state() == RunState.FAILED) {
        return false;
      }
      if (there.state() != RunState.QUEUED && there.steps() >= held.steps()) {
        return true;
      }
      try {
        Thread.sleep(CHECK_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return false;
      }
    }
    return false;
  }

  /** Destroys the run on the new host and resumes it on the old one. */
  void giveUp(double until) {
    to.close();
    resumeAt(from, until);
  }
}
