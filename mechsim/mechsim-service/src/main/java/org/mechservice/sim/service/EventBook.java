package org.mechservice.sim.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;

/** The latest events of a host or server, numbered, for operators who ask again and again. */
public final class EventBook {
  private static final int KEPT = 5000;

  private final Deque<ServiceEvent> events = new ArrayDeque<>();
  private long lastSeqNo;
  private boolean closed;

  /**
   * Adds an event under a number of this book, and if it has none, with the time of now. The event
   * itself may be in another book and is not modified.
   *
   * @return what was added
   */
  public synchronized ServiceEvent add(ServiceEvent event) {
    lastSeqNo++;
    ServiceEvent added =
        new ServiceEvent(
            lastSeqNo,
            event.happenedAt == 0 ? System.currentTimeMillis() : event.happenedAt,
            event.kind,
            event.level,
            event.code,
            event.hostName,
            event.sessionId,
            event.simId,
            event.owner,
            event.text);
    events.addLast(added);
    if (events.size() > KEPT) {
      events.removeFirst();
    }
    notifyAll();
    return added;
  }

  /**
   * Returns what happened after an event, waiting until there is something.
   *
   * @param afterSeqNo number of the last event already known
   * @param maxCount most events to return
   * @param millis longest wait, ms
   */
  public synchronized ServiceEvent[] after(long afterSeqNo, long maxCount, long millis) {
    awaitAfter(afterSeqNo, millis);
    List<ServiceEvent> found = new ArrayList<>();
    for (ServiceEvent event : events) {
      if (event.seqNo > afterSeqNo && found.size() < maxCount) {
        found.add(event);
      }
    }
    return found.toArray(ServiceEvent[]::new);
  }

  private void awaitAfter(long afterSeqNo, long millis) {
    long deadline = System.nanoTime() + millis * 1_000_000;
    try {
      while (lastSeqNo <= afterSeqNo && !closed) {
        long left = (deadline - System.nanoTime() + 999_999) / 1_000_000;
        if (left <= 0) {
          return;
        }
        wait(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Lets nobody wait any more. */
  public synchronized void close() {
    closed = true;
    notifyAll();
  }

  /** Returns the word for a severity in logs. */
  public static String level(Severity severity) {
    return switch (severity.value()) {
      case Severity._SEV_ERROR -> "ERROR";
      case Severity._SEV_WARNING -> "WARN";
      default -> "INFO";
    };
  }

  /** Returns an event as one line for people. */
  static String line(ServiceEvent event) {
    return String.format(
        Locale.ROOT, "%s%s", event.code.isEmpty() ? "" : event.code + " ", event.text);
  }
}
