package org.mechservice.sim.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimEvent;

/**
 * What happened in a session, for clients that ask instead of being called back. Of each
 * simulation's progress only the latest is kept, of the rest the latest {@value #KEPT} events.
 */
final class EventLog {
  private static final int KEPT = 500;

  private final Deque<SimEvent> events = new ArrayDeque<>();
  private long lastSeqNo;
  private boolean closed;

  /** Adds that a simulation changed its state. */
  synchronized void status(Progress progress, String text) {
    add(progress, text, new Diagnostic[0]);
  }

  /** Adds messages about a simulation. */
  synchronized void messages(Progress progress, Diagnostic[] messages) {
    add(progress, "", messages);
  }

  /** Adds how far a simulation is, in place of what was said of that before. */
  synchronized void progress(Progress progress) {
    events.removeIf(event -> isProgressOnly(event) && event.info.simId.equals(progress.simId));
    add(progress, "", new Diagnostic[0]);
  }

  private static boolean isProgressOnly(SimEvent event) {
    return event.text.isEmpty() && event.messages.length == 0;
  }

  private void add(Progress progress, String text, Diagnostic[] messages) {
    lastSeqNo++;
    events.addLast(new SimEvent(lastSeqNo, System.currentTimeMillis(), progress, text, messages));
    if (events.size() > KEPT) {
      events.removeFirst();
    }
    notifyAll();
  }

  /**
   * Returns what happened after an event, waiting until there is something.
   *
   * @param afterSeqNo number of the last event already known
   * @param maxCount most events to return
   * @param millis longest wait, ms
   */
  synchronized SimEvent[] after(long afterSeqNo, int maxCount, long millis)
      throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    while (lastSeqNo <= afterSeqNo && !closed) {
      long left = (deadline - System.nanoTime() + 999_999) / 1_000_000;
      if (left <= 0) {
        break;
      }
      wait(left);
    }
    List<SimEvent> found = new ArrayList<>();
    for (SimEvent event : events) {
      if (event.seqNo > afterSeqNo && found.size() < maxCount) {
        found.add(event);
      }
    }
    return found.toArray(SimEvent[]::new);
  }

  /** Returns the events of one simulation. */
  synchronized List<SimEvent> of(String simId) {
    return events.stream().filter(event -> event.info.simId.equals(simId)).toList();
  }

  /** Lets nobody wait any more. */
  synchronized void close() {
    closed = true;
    notifyAll();
  }
}
