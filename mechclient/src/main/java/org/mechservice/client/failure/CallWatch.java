package org.mechservice.client.failure;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Says of calls that wait for their answer for longer than any should: a server or host that is
 * frozen or cut off is told within seconds, long before its calls end. Thread-safe.
 */
final class CallWatch {
  private static final Logger LOG = LoggerFactory.getLogger(CallWatch.class);
  private static final CallWatch SHARED = new CallWatch();

  /** A healthy host answers within a second, and a loaded one within a few. */
  private static final long PATIENCE_SECONDS = 5;

  private static final long LOOK_MILLIS = 500;

  private static final class Waiting {
    private final String address;
    private final long since = System.nanoTime();
    private boolean told;

    private Waiting(String address) {
      this.address = address;
    }
  }

  private final Set<Waiting> calls = ConcurrentHashMap.newKeySet();
  private boolean looking;

  private CallWatch() {}

  /** A call that returns something. */
  interface Call<T, E extends Exception> {
    T run() throws E;
  }

  /**
   * Makes a call.
   *
   * @param address of the server or host, for the message
   */
  static <T, E extends Exception> T around(String address, Call<T, E> call) throws E {
    Waiting waiting = new Waiting(address);
    SHARED.add(waiting);
    try {
      return call.run();
    } finally {
      SHARED.calls.remove(waiting);
      if (waiting.told) {
        LOG.info("the server at {} answers again", address);
      }
    }
  }

  private void add(Waiting waiting) {
    calls.add(waiting);
    synchronized (this) {
      if (!looking) {
        looking = true;
        Thread thread = new Thread(this::look, "mechclient-watch");
        thread.setDaemon(true);
        thread.start();
      }
    }
  }

  private void look() {
    do {
      try {
        Thread.sleep(LOOK_MILLIS);
      } catch (InterruptedException e) {
        // Nobody has this thread.
      }
      calls.forEach(CallWatch::tellIfLate);
    } while (goesOn());
  }

  private synchronized boolean goesOn() {
    looking = !calls.isEmpty();
    return looking;
  }

  private static void tellIfLate(Waiting waiting) {
    long seconds = TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - waiting.since);
    if (!waiting.told && seconds >= PATIENCE_SECONDS) {
      waiting.told = true;
      LOG.warn(
          "{} the server at {} has not answered for {} s: it is overloaded, frozen or cut off;"
              + " waiting for it",
          MessageCode.SERVER_SILENT,
          waiting.address,
          seconds);
    }
  }
}
