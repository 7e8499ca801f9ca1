package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The input of one connection, after decryption. Reads the headers of messages as they pass (OMG,
 * CORBA 3.0, section 15.4.1), to know of large ones before memory for them is taken, of fragments
 * that the ORB would put together without a bound, and of messages that do not arrive in time.
 */
final class RequestStream extends InputStream {
  private static final Logger LOG = LoggerFactory.getLogger(RequestStream.class);
  private static final int HEADER_BYTES = 12;
  private static final byte[] MAGIC = {'G', 'I', 'O', 'P'};
  private static final int FLAGS = 6;
  private static final int MORE_FRAGMENTS = 2;
  private static final int TYPE = 7;
  private static final int FRAGMENT = 7;
  private static final int LENGTH = 8;

  /** A fragment and a fragmented message of version 1.2 begin with the id of their request. */
  private static final int ID_BYTES = 4;

  /** Fragmented messages of one connection at once. */
  private static final int MOST_FRAGMENTED = 100;

  /** Time for the first message, and for any to go on, ns. */
  static final long PATIENCE_NANOS = 10_000_000_000L;

  /** Slowest that a message may arrive, ns for each byte: 20 kB/s. */
  private static final long NANOS_PER_BYTE = 50_000;

  /** Smaller messages need no room: there are not so many connections. */
  private static final int LARGE_BYTES = 1 << 16;

  private final Socket socket;
  private final InputStream in;
  private final RequestMemory room;
  private final byte[] header = new byte[HEADER_BYTES];
  private int headerBytes;
  private long bodyBytes;
  private final ByteBuffer id = ByteBuffer.allocate(ID_BYTES);

  /** Bytes so far of each message whose fragments arrive, by the id of its request. */
  private final Map<Integer, Long> fragmented = new HashMap<>();

  private final long openedAt = System.nanoTime();

  /** Whether a whole message has come. */
  private volatile boolean used;

  /** When the message that arrives began; 0 between messages. */
  private volatile long begunAt;

  private volatile long announced;

  /** Whether fragments of a message are missing. */
  private volatile boolean assembles;

  private long taken;
  private boolean closed;
  private volatile long movedAt = System.nanoTime();

  RequestStream(Socket socket, InputStream in, RequestMemory room) {
    this.socket = socket;
    this.in = in;
    this.room = room;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
  }

  @Override
  public int read(byte[] bytes, int start, int length) throws IOException {
    int count = in.read(bytes, start, length);
    movedAt = System.nanoTime();
    int place = start;
    while (place < start + count) {
      place += pass(bytes, place, start + count - place);
    }
    return count;
  }

  /** Follows the messages; returns how many bytes it has looked at. */
  private int pass(byte[] bytes, int start, int count) throws IOException {
    if (bodyBytes > 0) {
      int passed = (int) Math.min(bodyBytes, count);
      if (id.hasRemaining()) {
        id.put(bytes, start, Math.min(passed, id.remaining()));
      }
      bodyBytes -= passed;
      if (bodyBytes == 0) {
        end();
      }
      return passed;
    }
    if (headerBytes == 0) {
      begunAt = movedAt;
    }
    int missing = Math.min(HEADER_BYTES - headerBytes, count);
    System.arraycopy(bytes, start, header, headerBytes, missing);
    headerBytes += missing;
    if (headerBytes == HEADER_BYTES) {
      headerBytes = 0;
      begin();
    }
    return missing;
  }

  private void begin() throws IOException {
    ByteOrder order = (header[FLAGS] & 1) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    bodyBytes = ByteBuffer.wrap(header).order(order).getInt(LENGTH);
    if (bodyBytes < 0) {
      bodyBytes = 0;
      throw new IOException("a message whose length is negative");
    }
    announced = bodyBytes;
    id.clear().order(order);
    if (bodyBytes == 0) {
      end();
    }
    // LimitedBuffers refuses messages above the largest size.
    if (isLarge(bodyBytes)) {
      take(bodyBytes);
    }
  }

  private static boolean isLarge(long bytes) {
    return bytes > LARGE_BYTES && bytes <= LimitedBuffers.MAX_MESSAGE_BYTES;
  }

  /** A message is complete. */
  private void end() throws IOException {
    giveBack(isLarge(announced) ? announced : 0);
    if (Arrays.equals(header, 0, MAGIC.length, MAGIC, 0, MAGIC.length)) {
      used = true;
    }
    begunAt = 0;
    boolean more = (header[FLAGS] & MORE_FRAGMENTS) != 0;
    if (!id.hasRemaining() && (more || header[TYPE] == FRAGMENT)) {
      addFragment(id.getInt(0), more);
    }
  }

  /** Bounds what the ORB has put together of fragments, like a message that comes whole. */
  private void addFragment(int request, boolean more) throws IOException {
    if (!more) {
      Long together = fragmented.remove(request);
      giveBack(together == null ? 0 : together);
      assembles = !fragmented.isEmpty();
      return;
    }
    assembles = true;
    take(announced);
    fragmented.merge(request, announced, Long::sum);
    long all = fragmented.values().stream().mapToLong(Long::longValue).sum();
    if (all > LimitedBuffers.MAX_MESSAGE_BYTES || fragmented.size() > MOST_FRAGMENTED) {
      throw new IOException(
          "fragments of "
              + all
              + " bytes in "
              + fragmented.size()
              + " messages; at most "
              + LimitedBuffers.MAX_MESSAGE_BYTES
              + " bytes in "
              + MOST_FRAGMENTED
              + " are allowed");
    }
  }

  private void take(long bytes) throws IOException {
    if (!room.take(this, bytes)) {
      throw new IOException("no room for a message of " + bytes + " bytes");
    }
    boolean tooLate;
    synchronized (this) {
      tooLate = closed;
      taken += tooLate ? 0 : bytes;
    }
    if (tooLate) {
      room.giveBack(this, bytes);
    }
  }

  private void giveBack(long most) {
    long bytes;
    synchronized (this) {
      bytes = Math.min(most, taken);
      taken -= bytes;
    }
    if (bytes > 0) {
      room.giveBack(this, bytes);
    }
  }

  /** Returns how long nothing has come, ns. */
  long stalledNanos() {
    return System.nanoTime() - movedAt;
  }

  /** Returns whether a whole message has come. */
  boolean isUsed() {
    return used;
  }

  /**
   * Returns whether the peer is late: with its first message, or with the rest of one that has
   * begun. Bytes that have arrived and are not read yet are no fault of the peer.
   *
   * @param now the time, ns, as {@link System#nanoTime}
   */
  boolean isOverdue(long now) {
    long begun = begunAt;
    boolean late =
        begun == 0
            ? (!used && now - openedAt > PATIENCE_NANOS)
                || (assembles && now - movedAt > PATIENCE_NANOS)
            : now - movedAt > PATIENCE_NANOS
                || now - begun > PATIENCE_NANOS + announced * NANOS_PER_BYTE;
    return late && !hasUnread();
  }

  private boolean hasUnread() {
    try {
      return socket.getInputStream().available() > 0;
    } catch (IOException e) {
      return false; // it is closed
    }
  }

  /** Gives the connection up. */
  void abandon() {
    ended();
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("a connection does not close in order: {}", e.toString());
    }
  }

  /** Called when the connection is closed. */
  void ended() {
    synchronized (this) {
      closed = true;
    }
    giveBack(Long.MAX_VALUE);
  }

  @Override
  public int available() throws IOException {
    return in.available();
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
