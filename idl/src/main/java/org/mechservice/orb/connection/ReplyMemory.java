package org.mechservice.orb.connection;

import java.util.Comparator;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/**
 * The memory of an ORB for replies that are being made or are not read yet. A client that does not
 * read occupies a part of it, never a thread, and never all of it:
 *
 * <ul>
 *   <li>a servant asks how large its reply may be ({@link #share}); the share shrinks with the
 *       number of replies that wait;
 *   <li>if that does not suffice, the connection that has read nothing for longest is closed.
 * </ul>
 */
public final class ReplyMemory {
  /** The memory a thread has taken for the reply it makes. */
  private static final ThreadLocal<@Nullable Share> MAKING = new ThreadLocal<>();

  /** No answer takes more of what is left, so that there is always something left. */
  private static final int SHARES = 16;

  /** An answer in the making is there as numbers of a file, as numbers, and encoded, twice. */
  private static final int COPIES = 5;

  private static final long STALLED_NANOS = 1_000_000_000;

  private record Share(ReplyMemory room, long bytes) {}

  private final long size;
  private final AtomicLong making = new AtomicLong();
  private final AtomicLong waiting = new AtomicLong();
  private final Set<ReplyQueue> behind = ConcurrentHashMap.newKeySet();
  private final ExecutorService writers =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "mechservice-reply");
            thread.setDaemon(true);
            return thread;
          });

  ReplyMemory() {
    this(Runtime.getRuntime().maxMemory() / 4);
  }

  /**
   * @param size bytes that may be in use
   */
  ReplyMemory(long size) {
    this.size = size;
  }

  /**
   * Returns how large an answer may be, and sets its room aside until it is sent. Called by the
   * thread that works on a call, at most once for each.
   *
   * @param wanted bytes the answer would have
   * @param least bytes without which there is no answer
   */
  public long share(long wanted, long least) {
    long left = size - waiting.get() - making.get();
    long granted = Math.max(least, Math.min(wanted, left / SHARES / COPIES));
    making.addAndGet(COPIES * granted);
    MAKING.set(new Share(this, COPIES * granted));
    return granted;
  }

  /**
   * Called by the thread that works on a call when its answer is encoded, or when a new one begins.
   */
  public static void made() {
    Share share = MAKING.get();
    if (share != null) {
      share.room().making.addAndGet(-share.bytes());
      MAKING.remove();
    }
  }

  /** Returns the bytes of answers that were not taken yet. */
  long waiting() {
    return waiting.get();
  }

  /** Notes an answer that waits to be taken. */
  void added(ReplyQueue queue, long bytes) {
    waiting.addAndGet(bytes);
    behind.add(queue);
    if (waiting.get() > size) {
      relieve();
    }
  }

  /** Notes that bytes were taken, or will never be. */
  void taken(ReplyQueue queue, long bytes) {
    waiting.addAndGet(-bytes);
    if (queue.isEmpty()) {
      behind.remove(queue);
    }
  }

  void write(Runnable writing) {
    writers.execute(writing);
  }

  private synchronized void relieve() {
    while (waiting.get() > size) {
      Optional<ReplyQueue> longest =
          behind.stream()
              .filter(queue -> queue.stalledNanos() > STALLED_NANOS || waiting.get() > 2 * size)
              .max(Comparator.comparingLong(ReplyQueue::stalledNanos));
      if (longest.isEmpty()) {
        return; // all are reading
      }
      longest.get().abandon();
    }
  }

  void close() {
    writers.shutdown();
  }
}
