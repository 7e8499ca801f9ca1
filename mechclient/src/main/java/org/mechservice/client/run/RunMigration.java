package org.mechservice.client.run;

import java.util.Map;
import java.util.Optional;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServiceException;

/**
 * A run on its way to another host: held where it was and saved there, to go on elsewhere from its
 * checkpoint as soon as its rows up to then have been taken. The first host keeps the run until it
 * goes on elsewhere, so it can always go on where it was.
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
   * Holds a run and hands what it was saved as to the place where it shall go on.
   *
   * @param parameters that were set before its start
   * @param until where it shall be held, s; infinite: nowhere
   * @return empty if it stands nowhere to be saved just now; it goes on
   * @throws ServiceException if one of the hosts refuses; the run goes on where it is
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
      goOnAt(from, until);
      return Optional.empty();
    } catch (InvalidStateException e) {
      goOnAt(from, until);
      return Optional.empty();
    } catch (ServiceException e) {
      goOnAt(from, until);
      throw e;
    }
  }

  /** Lets the run go on where it was, unless it has ended there. */
  private static void goOnAt(HostedRun place, double until) {
    try {
      if (Double.isInfinite(until)) {
        place.calls().run(place.simulation()::resume);
      } else {
        place.calls().run(() -> place.simulation().runTo(until));
      }
    } catch (InvalidStateException e) {
      // It has ended: its rows tell how.
      return;
    }
  }

  /** Returns how many rows the first host has put out, all of which are to be taken there. */
  long rows() {
    return held.rows();
  }

  /** Returns the simulated time at which the run was held, s. */
  double time() {
    return held.time();
  }

  HostedRun to() {
    return to;
  }

  /**
   * Lets the run go on elsewhere.
   *
   * @return whether it does: not if it would have to wait there, or cannot be taken up
   */
  boolean goesOn(double until) {
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

  /** Gives the other place up and lets the run go on where it was. */
  void giveUp(double until) {
    to.close();
    goOnAt(from, until);
  }
}
