package org.mechservice.sim.service.limits;

import java.util.HashMap;
import java.util.Map;
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

  private final CurrentLimits limits;
  private final Map<String, Use> clients = new HashMap<>();

  public SetUpPlaces(CurrentLimits limits) {
    this.limits = limits;
  }

  /**
   * Takes a place, waiting for one if need be; {@link #leave} gives it back.
   *
   * @param client owner of the session
   * @throws LimitExceeded if too many of its set-ups wait, or it has waited too long
   * @throws CancellationException if the thread is interrupted: its session has ended
   */
  public synchronized void enter(String client) throws LimitExceeded {
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

  /** Gives a place back. */
  public synchronized void leave(String client) {
    Use use = clients.get(client);
    if (use != null) {
      use.running--;
      forget(client, use);
    }
    notifyAll();
  }

  private void forget(String client, Use use) {
    if (use.running == 0 && use.waiting == 0) {
      clients.remove(client);
    }
  }
}
