package org.mechservice.sim.service.contract;

import java.util.List;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimEvent;

/**
 * The events of one session, for clients that poll instead of being called back. Of the progress of
 * each simulation only the latest is kept, of all else the latest {@value #KEPT} events.
 */
public final class SessionEvents {
  private static final int KEPT = 500;
  private static final Diagnostic[] NONE = {};

  private final EventBuffer<SimEvent> events = new EventBuffer<>(KEPT, event -> event.seqNo);

  private static SimEvent event(long number, Progress progress, String text, Diagnostic[] said) {
    return new SimEvent(number, System.currentTimeMillis(), progress, text, said);
  }

  /** Adds a change of state of a simulation. */
  public void status(Progress progress, String text) {
    events.add(number -> event(number, progress, text, NONE));
  }

  /** Adds messages about a simulation. */
  public void messages(Progress progress, Diagnostic[] messages) {
    events.add(number -> event(number, progress, "", messages));
  }

  /** Adds the progress of a simulation, in place of its earlier progress. */
  public void progress(Progress progress) {
    events.replace(
        event -> isProgressOnly(event) && event.info.simId.equals(progress.simId),
        number -> event(number, progress, "", NONE));
  }

  private static boolean isProgressOnly(SimEvent event) {
    return event.text.isEmpty() && event.messages.length == 0;
  }

  /**
   * Returns the events after a number; waits until there is one.
   *
   * @param afterSeqNo number of the last event already known
   * @param maxCount most events to return
   * @param millis longest wait, ms
   */
  public SimEvent[] after(long afterSeqNo, int maxCount, long millis) throws InterruptedException {
    return events.after(afterSeqNo, maxCount, millis).toArray(SimEvent[]::new);
  }

  /** Returns the events of one simulation. */
  public List<SimEvent> of(String simId) {
    return events.matching(event -> event.info.simId.equals(simId));
  }

  /** Wakes all clients that wait; later calls do not wait. */
  public void close() {
    events.close();
  }
}
