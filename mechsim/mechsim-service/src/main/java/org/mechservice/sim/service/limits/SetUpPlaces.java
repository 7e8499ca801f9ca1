package org.mechservice.sim.service.limits;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import org.mechservice.idl.LimitExceeded;

/**
 * The set-ups that are under way on a host: models that are read, checked, generated or built. A
 * client has a limited number at once; its further ones wait, and beyond a number that wait are
 * refused, so that one client leaves processors and threads to the others. Thread-safe.
 */
public final class SetUpPlaces {
  /** Set-ups of one client that wait; each holds a thread. */
  private static final int MOST_WAITING = 64;

  private static final long PATIENCE_SECONDS = 300;

  private static final class Use {
    private int running;
    private int waiting;
  }

  /** A set-up that is under way, in the thread that has entered. */
  public static final class Place {
    private final String client;
    private final Thread thread = Thread.currentThread();
    private final long since = System.nanoTime();
    private boolean late;

    private Place(String client) {
      this.client = client;
    }
  }

  private final CurrentLimits limits;
  private final Map<String, Use> clients = new HashMap<>();
  private final Set<Place> taken = new HashSet<>();

  public SetUpPlaces(CurrentLimits limits) {
    this.limits = limits;
  }

  /**
   * Takes a place, waiting for one if need be; {@link #leave} gives it back.
   *
   * @param client owner of the session
   * @return the place
   * @throws LimitExceeded if too many of its set-ups wait, or it has waited too long
   * @throws CancellationException if the thread is interrupted: its session has ended
   */
  public synchronized Place enter(String client) throws LimitExceeded {
    Use use = clients.computeIfAbsent(client, c -> new Use());
    if (use.running >= most() && use.waiting >= MOST_WAITING) {
      throw refusal(use);
    }
    use.waiting++;
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    try {
      while (use.running >= most()) {
        long left = end - System.nanoTime();
        if (left <= 0) {
          throw refusal(use);
        }
        TimeUnit.NANOSECONDS.timedWait(this, left);
      }
      use.running++;
      Place place = new Place(client);
      taken.add(place);
      return place;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException("the session has ended");
    } finally {
      use.waiting--;
      forget(client, use);
    }
  }

  private long most() {
    return limits.now().bound(HostLimit.CLIENT_BUILDS);
  }

  private LimitExceeded refusal(Use use) {
    long most = limits.now().of(HostLimit.CLIENT_BUILDS);
    return HostLimit.CLIENT_BUILDS.refusal(
        most,
        use.running + use.waiting,
        "this host sets up "
            + most
            + " models of one client at once, and "
            + use.waiting
            + " wait; try again later");
  }

  /**
   * Gives a place back.
   *
   * @return whether its thread was interrupted because the set-up has taken too long; the thread is
   *     not interrupted any more
   */
  public synchronized boolean leave(Place place) {
    taken.remove(place);
    Use use = clients.get(place.client);
    if (use != null) {
      use.running--;
      forget(place.client, use);
    }
    notifyAll();
    return place.late && Thread.interrupted();
  }

  /** Interrupts set-ups that have taken too long. */
  public synchronized void interruptLate() {
    long most = limits.now().bound(HostLimit.SET_UP_TIME);
    for (Place place : taken) {
      if (!place.late && (System.nanoTime() - place.since) / 1_000_000_000 >= most) {
        place.late = true;
        place.thread.interrupt();
      }
    }
  }

  /** Returns the refusal of a set-up that has taken too long. */
  public LimitExceeded tooLong() {
    return tooLong(limits.now());
  }

  /** Returns the refusal of a set-up that has taken too long. */
  public static LimitExceeded tooLong(HostLimits limits) {
    long most = limits.of(HostLimit.SET_UP_TIME);
    return HostLimit.SET_UP_TIME.refusal(
        most,
        most,
        "the model was not set up within the "
            + most
            + " s that this host gives one ("
            + HostLimit.SET_UP_TIME.label()
            + "); leave out loops that repeat others, or divide the"
            + " model");
  }

  /** Returns the refusal of a set-up for which the memory did not suffice. */
  public static LimitExceeded tooLarge() {
    return tooLarge(HostLimit.MEMORY, Runtime.getRuntime().maxMemory());
  }

  /**
   * Returns the refusal of a set-up for which the memory did not suffice.
   *
   * @param most memory that it had, B
   */
  public static LimitExceeded tooLarge(HostLimit limit, long most) {
    return limit.refusal(
        most,
        most,
        "the set-up of the model needs more than the "
            + (most >> 20)
            + " MB of memory that this host gives it ("
            + limit.label()
            + "); leave out loops that repeat others, or divide the"
            + " model");
  }

  private void forget(String client, Use use) {
    if (use.running == 0 && use.waiting == 0) {
      clients.remove(client);
    }
  }
}
