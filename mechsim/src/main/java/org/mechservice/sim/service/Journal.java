package org.mechservice.sim.service;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.mechservice.idl.LogLine;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What happened on a host or server lately: written to the log, and kept for administrators. */
public final class Journal {
  private static final int KEPT = 1000;

  private final Logger log;
  private final String source;
  private final Deque<LogLine> lines = new ArrayDeque<>();

  /**
   * @param source whose journal it is
   */
  public Journal(String source) {
    this.source = source;
    log = LoggerFactory.getLogger(Journal.class.getPackageName() + "." + source);
  }

  /** Writes down something ordinary. */
  public void info(String text) {
    log.info(text);
    add("INFO", text);
  }

  /** Writes down something an operator should look at. */
  public void warn(String text) {
    log.warn(text);
    add("WARN", text);
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
