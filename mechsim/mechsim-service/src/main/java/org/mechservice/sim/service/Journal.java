package org.mechservice.sim.service;

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
 * What happened on a host or server lately: written to the log, and kept for administrators as
 * lines and as events.
 */
public final class Journal {
  private static final int KEPT = 1000;

  private final Logger log;
  private final String source;
  private final Deque<LogLine> lines = new ArrayDeque<>();
  private final EventBook events = new EventBook();
  private final Consumer<ServiceEvent> listener;

  /**
   * @param source whose journal it is
   */
  public Journal(String source) {
    this(source, event -> {});
  }

  /**
   * @param source whose journal it is
   * @param listener told every event at once; must not block for long
   */
  public Journal(String source, Consumer<ServiceEvent> listener) {
    this(source, listener, LoggerFactory.getLogger(Journal.class.getPackageName() + "." + source));
  }

  private Journal(String source, Consumer<ServiceEvent> listener, Logger log) {
    this.source = source;
    this.listener = listener;
    this.log = log;
  }

  /** Returns a journal of what is nobody's business: nothing gets from it to a log. */
  static Journal unwritten() {
    return new Journal("", event -> {}, NOPLogger.NOP_LOGGER);
  }

  /** Returns the events. */
  public EventBook events() {
    return events;
  }

  /** Writes an event down. */
  public void tell(Happening happening) {
    ServiceEvent event = happening.event(source);
    String text = EventBook.line(event);
    if (event.level.value() == Severity._SEV_INFO) {
      log.info(text);
    } else {
      log.warn(text);
    }
    add(EventBook.level(event.level), text);
    listener.accept(events.add(event));
  }

  /** Writes an event of a host down again where a server keeps those of all its hosts. */
  public void retell(ServiceEvent event) {
    add(EventBook.level(event.level), event.hostName + ": " + EventBook.line(event));
    listener.accept(events.add(event));
  }

  private synchronized void add(String level, String text) {
    lines.addLast(new LogLine(System.currentTimeMillis(), level, source, text));
    if (lines.size() > KEPT) {
      lines.removeFirst();
    }
  }

  /**
   * Returns what was written since a time, oldest first.
   *
   * @param since UTC, ms since 1970-01-01
   * @param maxCount most lines to return
   */
  public synchronized LogLine[] since(long since, int maxCount) {
    List<LogLine> found = lines.stream().filter(line -> line.writtenAt >= since).toList();
    return found.stream().limit(Integer.toUnsignedLong(maxCount)).toArray(LogLine[]::new);
  }
}
