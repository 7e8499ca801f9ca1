package org.mechservice.sim.service.contract;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.helpers.NOPLogger;

/**
 * The events of a host or a server: written to the log, and the latest kept for administrators, as
 * log lines and as numbered events. Thread-safe.
 */
public final class Journal {
  /** Name of the loggers of all journals, before a dot and the name of the host or server. */
  public static final String LOGGER = "org.mechservice.sim.service";

  private static final int LINES_KEPT = 1000;
  private static final int EVENTS_KEPT = 5000;

  private final Logger log;
  private final String source;
  private final Deque<LogLine> lines = new ArrayDeque<>();
  private final EventBuffer<ServiceEvent> events =
      new EventBuffer<>(EVENTS_KEPT, event -> event.seqNo);
  private final Consumer<ServiceEvent> listener;

  /**
   * @param source name of the host or server
   */
  public Journal(String source) {
    this(source, event -> {});
  }

  /**
   * @param source name of the host or server
   * @param listener receives every event at once; must not block for long
   */
  public Journal(String source, Consumer<ServiceEvent> listener) {
    this(source, listener, LoggerFactory.getLogger(LOGGER + "." + source));
  }

  private Journal(String source, Consumer<ServiceEvent> listener, Logger log) {
    this.source = source;
    this.listener = listener;
    this.log = log;
  }

  /** Returns a journal that writes to no log. */
  public static Journal unlogged() {
    return new Journal("", event -> {}, NOPLogger.NOP_LOGGER);
  }

  /** Adds an event and logs it. */
  public void add(JournalEntry entry) {
    ServiceEvent event = entry.event(source);
    log(event.level, line(event));
    addEvent(event);
  }

  /** Logs a line that is about no event. */
  public void log(Severity level, String text) {
    if (level.value() == Severity._SEV_INFO) {
      log.info(text);
    } else {
      log.warn(text);
    }
    addLine(level(level), text);
  }

  /** Adds an event that a host has logged, where a server keeps the events of all its hosts. */
  public void addOfHost(ServiceEvent event) {
    addLine(level(event.level), event.hostName + ": " + line(event));
    addEvent(event);
  }

  /** Adds a copy under a number of this journal; an event without a time gets the present one. */
  private void addEvent(ServiceEvent event) {
    ServiceEvent added =
        events.add(
            number ->
                new ServiceEvent(
                    number,
                    event.happenedAt == 0 ? System.currentTimeMillis() : event.happenedAt,
                    event.kind,
                    event.level,
                    event.code,
                    event.hostName,
                    event.sessionId,
                    event.simId,
                    event.owner,
                    event.text));
    listener.accept(added);
  }

  private synchronized void addLine(String level, String text) {
    lines.addLast(new LogLine(System.currentTimeMillis(), level, source, text));
    if (lines.size() > LINES_KEPT) {
      lines.removeFirst();
    }
  }

  /**
   * Returns the log lines since a time, oldest first.
   *
   * @param since UTC, ms since 1970-01-01
   * @param maxCount most lines to return
   */
  public synchronized LogLine[] since(long since, int maxCount) {
    List<LogLine> found = lines.stream().filter(line -> line.writtenAt >= since).toList();
    return found.stream().limit(Integer.toUnsignedLong(maxCount)).toArray(LogLine[]::new);
  }

  /**
   * Returns the events after a number; waits until there is one, or the thread is interrupted.
   *
   * @param afterSeqNo number of the last event already known
   * @param maxCount most events to return
   * @param millis longest wait, ms
   */
  public ServiceEvent[] eventsAfter(long afterSeqNo, long maxCount, long millis) {
    try {
      return events.after(afterSeqNo, maxCount, millis).toArray(ServiceEvent[]::new);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new ServiceEvent[0];
    }
  }

  /** Wakes all readers that wait for events; later calls do not wait. */
  public void close() {
    events.close();
  }

  /** Returns the word for a severity in logs. */
  public static String level(Severity severity) {
    return switch (severity.value()) {
      case Severity._SEV_ERROR -> "ERROR";
      case Severity._SEV_WARNING -> "WARN";
      default -> "INFO";
    };
  }

  private static String line(ServiceEvent event) {
    return event.code.isEmpty() ? event.text : event.code + " " + event.text;
  }
}
