package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The output of one connection. Writing never waits for the peer: bytes that the peer does not read
 * at once are written by a thread of the connection, which ends when the peer has caught up.
 */
final class ReplyQueue extends OutputStream {
  private static final Logger LOG = LoggerFactory.getLogger(ReplyQueue.class);
  private static final int SLICE_BYTES = 1 << 16;

  /** Longest wait at closing for a peer that reads nothing, ms. */
  private static final long LAST_BYTES_MILLIS = 1000;

  private final Socket socket;
  private final OutputStream out;
  private final ReplyMemory room;
  private final Deque<byte[]> waiting = new ArrayDeque<>();
  private volatile long movedAt = System.nanoTime();
  private boolean writing;
  private boolean broken;

  /**
   * @param out to the other end
   */
  ReplyQueue(Socket socket, OutputStream out, ReplyMemory room) {
    this.socket = socket;
    this.out = out;
    this.room = room;
  }

  @Override
  public void write(int octet) throws IOException {
    write(new byte[] {(byte) octet}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int start, int length) throws IOException {
    if (length == 0) {
      return;
    }
    boolean idle;
    synchronized (this) {
      if (broken) {
        throw new IOException("the connection is closed");
      }
      if (waiting.isEmpty()) {
        movedAt = System.nanoTime();
      }
      waiting.add(Arrays.copyOfRange(bytes, start, start + length));
      idle = !writing;
      writing = true;
    }
    room.added(this, length);
    if (idle) {
      room.write(this::writeAll);
    }
  }

  private void writeAll() {
    try {
      for (byte[] next = next(); next.length > 0; next = next()) {
        for (int start = 0; start < next.length; start += SLICE_BYTES) {
          out.write(next, start, Math.min(SLICE_BYTES, next.length - start));
          movedAt = System.nanoTime();
        }
        written(next.length);
      }
    } catch (IOException e) {
      LOG.debug("a reader is gone: {}", e.toString());
      abandon();
    }
  }

  private synchronized byte[] next() {
    byte[] next = waiting.peek();
    writing = next != null;
    return next == null ? new byte[0] : next;
  }

  private void written(int bytes) {
    synchronized (this) {
      if (waiting.poll() == null) {
        return; // was abandoned
      }
      notifyAll();
    }
    room.taken(this, bytes);
  }

  synchronized boolean isEmpty() {
    return waiting.isEmpty();
  }

  /** Returns how long the reader has taken nothing that waits for him, ns; 0 if nothing does. */
  long stalledNanos() {
    return isEmpty() ? 0 : System.nanoTime() - movedAt;
  }

  /** Gives the connection up: what waits will never be read. */
  void abandon() {
    long bytes = 0;
    synchronized (this) {
      if (broken) {
        return;
      }
      broken = true;
      for (byte[] one : waiting) {
        bytes += one.length;
      }
      waiting.clear();
      notifyAll();
    }
    room.taken(this, bytes);
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("a connection does not close in order: {}", e.toString());
    }
  }

  /** Waits until the last bytes are written, as long as the reader takes some. */
  synchronized void finish() {
    try {
      while (!waiting.isEmpty()) {
        long left = LAST_BYTES_MILLIS - (System.nanoTime() - movedAt) / 1_000_000;
        if (left <= 0) {
          return;
        }
        wait(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
