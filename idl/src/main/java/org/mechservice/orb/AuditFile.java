package org.mechservice.orb;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;
import org.mechservice.solver.text.OwnerOnly;
import org.mechservice.solver.text.WellFormedText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The file of an audit log, of one line for each event, which is in the file before anything else
 * happens. The owner of the process alone may read it.
 *
 * <p>Any text is written, whatever characters it has. An event that cannot be written is kept and
 * tried again, in its order, with the next event and each second; the log says when this begins and
 * ends. What cannot be kept either is in the log in full. A file that was moved away or deleted is
 * made anew.
 */
public final class AuditFile implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AuditFile.class);
  private static final long RETRY_MILLIS = 1000;

  /** Events that are kept while none can be written; some 50 MB. */
  private static final int MOST_WAITING = 100_000;

  private final MessageCode code;
  private final Path file;
  private final Deque<String> waiting = new ArrayDeque<>();
  private final Thread retries = new Thread(this::retry, "mechservice-audit");
  private FileChannel out;
  private @Nullable Object key;
  private boolean failing;
  private boolean torn;
  private long late;

  /**
   * Opens a file to append to.
   *
   * @param code of messages about it
   * @throws IOException if it cannot be written
   */
  @SuppressWarnings("this-escape") // retried when all is set
  public AuditFile(MessageCode code, Path file) throws IOException {
    this.code = code;
    this.file = file;
    out = opened(file);
    key = keyOf(file);
    retries.setDaemon(true);
    retries.start();
  }

  private FileChannel opened(Path file) throws IOException {
    FileChannel channel =
        FileChannel.open(
            file, Set.of(StandardOpenOption.CREATE, StandardOpenOption.APPEND), OwnerOnly.file());
    try {
      OwnerOnly.restrict(file);
    } catch (IOException e) {
      LOG.warn(code + " others may read the audit log {}: {}", file, FileErrors.reason(e));
    }
    return channel;
  }

  /** Returns what tells the file of this name from another one; null if there is none. */
  private static @Nullable Object keyOf(Path file) {
    try {
      return Files.readAttributes(file, BasicFileAttributes.class).fileKey();
    } catch (IOException e) {
      return null;
    }
  }

  /**
   * Writes an event.
   *
   * @param event one line
   */
  public synchronized void write(String event) {
    waiting.add(WellFormedText.of(event));
    if (waiting.size() > MOST_WAITING) {
      LOG.error(code + " missing in the audit log {}: {}", file, waiting.removeFirst());
    }
    writeWaiting();
  }

  private void retry() {
    try {
      while (true) {
        Thread.sleep(RETRY_MILLIS);
        synchronized (this) {
          if (failing) {
            writeWaiting();
          }
        }
      }
    } catch (InterruptedException e) {
      // It is closed.
    }
  }

  /** Returns how many events wait because they could not be written. */
  public synchronized int waiting() {
    return waiting.size();
  }

  private void writeWaiting() {
    try {
      followFile();
      while (!waiting.isEmpty()) {
        append(waiting.getFirst());
        waiting.removeFirst();
        late += failing ? 1 : 0;
      }
      if (failing) {
        LOG.warn(code + " the audit log {} can be written again; {} events came late", file, late);
        failing = false;
        late = 0;
      }
    } catch (IOException e) {
      if (!failing) {
        LOG.error(
            code + " the audit log {} cannot be written: {}; events are kept and tried again",
            file,
            FileErrors.reason(e));
        failing = true;
      }
    }
  }

  /** Goes on in a new file if the one of this name is no longer the one that is open. */
  private void followFile() throws IOException {
    Object now = keyOf(file);
    if (!Objects.equals(now, key) || !out.isOpen()) {
      FileChannel next = opened(file);
      out.close();
      out = next;
      key = keyOf(file);
      torn = false;
    }
  }

  /** Appends a line, or nothing: the part of a line that did not fit is taken back. */
  private void append(String line) throws IOException {
    ByteBuffer bytes =
        ByteBuffer.wrap(((torn ? "\n" : "") + line + "\n").getBytes(StandardCharsets.UTF_8));
    long before = out.size();
    try {
      while (bytes.hasRemaining()) {
        out.write(bytes);
      }
      torn = false;
    } catch (IOException e) {
      if (bytes.position() > 0) {
        torn = true;
        out.truncate(before);
        torn = false;
      }
      throw e;
    }
  }

  @Override
  public synchronized void close() {
    retries.interrupt();
    writeWaiting();
    waiting.forEach(line -> LOG.error(code + " missing in the audit log {}: {}", file, line));
    try {
      out.close();
    } catch (IOException e) {
      LOG.warn(
          MessageCode.UNCLEAN_CLOSE + " the audit log {} does not close in order: {}",
          file,
          e.toString());
    }
  }
}
