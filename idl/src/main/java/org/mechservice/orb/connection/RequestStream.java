package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The input of one connection, after decryption. Reads the headers of messages before the ORB does
 * (OMG, CORBA 3.0, section 15.4.1), to know of large ones before memory for them is taken, of
 * fragments that the ORB would put together without a bound, and of messages that do not arrive in
 * time.
 *
 * <p>A request that is too large still gets an answer: the ORB gets its beginning alone, as a
 * request of its own, the rest is thrown away as it arrives, and {@link InboundCall} tells the
 * receiver that arguments are missing. Other messages that are too large end the connection.
 */
final class RequestStream extends InputStream {
  private static final Logger LOG = LoggerFactory.getLogger(RequestStream.class);
  private static final int HEADER_BYTES = 12;
  private static final byte[] MAGIC = {'G', 'I', 'O', 'P'};
  private static final int MAJOR = 4;
  private static final int MINOR = 5;
  private static final int FLAGS = 6;
  private static final int MORE_FRAGMENTS = 2;
  private static final int TYPE = 7;
  private static final int REQUEST = 0;
  private static final int FRAGMENT = 7;
  private static final int LENGTH = 8;

  /** A fragment and a message of version 1.2 begin with the id of their request. */
  private static final int ID_BYTES = 4;

  /** Where the body of a request says who answers it, and what it may say (section 15.4.2.1). */
  private static final int RESPONSE_FLAGS = ID_BYTES;

  private static final Set<Byte> KNOWN_RESPONSES = Set.of((byte) 0, (byte) 1, (byte) 3);

  /** Fragmented messages, or refused requests that are not answered yet, of one connection. */
  private static final int MOST_FRAGMENTED = 100;

  /** What the ORB gets of a request that is too large: enough for whom and what it asks, B. */
  private static final int BEGINNING_BYTES = 1 << 14;

  /** Most that is thrown away of a request that is too large, B; a larger one gets no answer. */
  private static final long MOST_DROPPED_BYTES = 4L * LimitedBuffers.MAX_MESSAGE_BYTES;

  /** Time for the first message, and for any to go on, ns. */
  static final long PATIENCE_NANOS = 10_000_000_000L;

  /** Slowest that a message may arrive, ns for each byte: 20 kB/s. */
  private static final long NANOS_PER_BYTE = 50_000;

  /** Smaller messages need no room: there are not so many connections. */
  private static final int LARGE_BYTES = 1 << 16;

  private final Socket socket;
  private final InputStream in;
  private final RequestMemory room;

  /** The header of a message, and the id after it where a decision needs both. */
  private final byte[] head = new byte[HEADER_BYTES + ID_BYTES];

  private int headBytes;
  private int headWanted = HEADER_BYTES;

  /** How much of the head the ORB is to get, and has got. */
  private int headPassing;

  private int headPassed;

  /** What the ORB has got of the body, and is still to get. */
  private long bodyPassed;

  private long bodyBytes;

  /** The thread that reads; it dies of messages that the ORB cannot read. */
  private volatile @Nullable Thread reader;

  /** What is thrown away after that. */
  private long droppedBytes;

  private final ByteBuffer id = ByteBuffer.allocate(ID_BYTES);

  /** Bytes so far of each message whose fragments arrive, by the id of its request. */
  private final Map<Integer, Long> fragmented = new HashMap<>();

  /** The requests among them. */
  private final Set<Integer> fragmentedRequests = new HashSet<>();

  /** Refused requests whose fragments still arrive. */
  private final Set<Integer> unfinished = new HashSet<>();

  private long droppedInAll;

  /** Sizes of the requests that are too large and not yet answered, by their ids. */
  private final Map<Integer, Long> refused = new ConcurrentHashMap<>();

  private final long openedAt = System.nanoTime();

  /** Whether a whole message has come. */
  private volatile boolean used;

  /** When the message that arrives began; 0 between messages. */
  private volatile long begunAt;

  private volatile long announced;

  /** Whether fragments of a message are missing. */
  private volatile boolean assembles;

  /** Room of the message that arrives, and of all of this connection. */
  private long takenForMessage;

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
    if (length == 0) {
      return 0;
    }
    while (headPassed == headPassing && bodyBytes == 0) {
      if (droppedBytes > 0 ? !drop() : !readHead()) {
        return -1;
      }
    }
    return headPassed < headPassing ? passHead(bytes, start, length) : pass(bytes, start, length);
  }

  private int receive(byte[] bytes, int start, int length) throws IOException {
    reader = Thread.currentThread();
    int count = in.read(bytes, start, length);
    movedAt = System.nanoTime();
    return count;
  }

  /** Reads some of a head, and decides about the message if that is enough; false: at the end. */
  private boolean readHead() throws IOException {
    int count = receive(head, headBytes, headWanted - headBytes);
    if (count < 0) {
      return false;
    }
    if (headBytes == 0) {
      begunAt = movedAt;
    }
    headBytes += count;
    if (headBytes == headWanted) {
      begin();
    }
    return true;
  }

  private int passHead(byte[] bytes, int start, int length) {
    int count = Math.min(headPassing - headPassed, length);
    System.arraycopy(head, headPassed, bytes, start, count);
    headPassed += count;
    return count;
  }

  private int pass(byte[] bytes, int start, int length) throws IOException {
    int count = receive(bytes, start, (int) Math.min(bodyBytes, length));
    if (count > 0) {
      id.put(bytes, start, Math.min(count, id.remaining()));
      long flags = RESPONSE_FLAGS - bodyPassed;
      if (flags >= 0 && flags < count) {
        requireKnownResponse(bytes[start + (int) flags]);
      }
      bodyPassed += count;
      bodyBytes -= count;
      endIfComplete();
    }
    return count;
  }

  /** The ORB would lose a thread to a request that asks for an answer it does not know. */
  private void requireKnownResponse(byte flags) throws IOException {
    if (isCurrent() && head[TYPE] == REQUEST && !KNOWN_RESPONSES.contains(flags)) {
      throw new IOException("a request with the response flags " + flags);
    }
  }

  /** Throws some of the message away; false: at the end. */
  private boolean drop() throws IOException {
    byte[] nothing = new byte[(int) Math.min(droppedBytes, LARGE_BYTES)];
    int count = receive(nothing, 0, nothing.length);
    if (count < 0) {
      return false;
    }
    droppedInAll += count;
    if (droppedInAll > MOST_DROPPED_BYTES) {
      throw new IOException("a request of more than " + MOST_DROPPED_BYTES + " bytes");
    }
    droppedBytes -= count;
    endIfComplete();
    return true;
  }

  private void endIfComplete() throws IOException {
    if (bodyBytes == 0 && droppedBytes == 0) {
      end();
    }
  }

  private ByteOrder order() {
    return (head[FLAGS] & 1) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
  }

  private boolean hasMore() {
    return (head[FLAGS] & MORE_FRAGMENTS) != 0;
  }

  private void begin() throws IOException {
    long length = ByteBuffer.wrap(head).order(order()).getInt(LENGTH);
    if (length < 0) {
      throw new IOException("a message whose length is negative");
    }
    if (headBytes == HEADER_BYTES && concernsRefused(length)) {
      headWanted = head.length;
      return;
    }
    announced = length;
    bodyPassed = (long) headBytes - HEADER_BYTES;
    id.clear().order(order());
    if (headBytes == head.length) {
      beginWithId(length);
    } else {
      headPassing = HEADER_BYTES;
      bodyBytes = length;
      takeIfLarge(length);
    }
    headPassed = 0;
    headBytes = 0;
    headWanted = HEADER_BYTES;
    endIfComplete();
  }

  /** Returns whether a message belongs to a request that is, or has been found to be, too large. */
  private boolean concernsRefused(long length) {
    if (!isCurrent() || length < ID_BYTES || length > MOST_DROPPED_BYTES) {
      return false;
    }
    return switch (head[TYPE]) {
      case REQUEST -> length + (hasMore() ? together() : 0) > LimitedBuffers.MAX_MESSAGE_BYTES;
      case FRAGMENT ->
          !unfinished.isEmpty()
              || (!fragmentedRequests.isEmpty()
                  && length + together() > LimitedBuffers.MAX_MESSAGE_BYTES);
      default -> false;
    };
  }

  private long together() {
    return fragmented.values().stream().mapToLong(Long::longValue).sum();
  }

  /** Returns whether it is a message whose body begins with the id of its request. */
  private boolean isCurrent() {
    return isMessage() && head[MAJOR] == 1 && head[MINOR] >= 2;
  }

  private boolean isMessage() {
    return Arrays.equals(head, 0, MAGIC.length, MAGIC, 0, MAGIC.length);
  }

  private void beginWithId(long length) throws IOException {
    int request = ByteBuffer.wrap(head).order(order()).getInt(HEADER_BYTES);
    if (head[TYPE] == FRAGMENT && unfinished.contains(request)) {
      headPassing = 0;
      droppedBytes = length - ID_BYTES;
      if (!hasMore()) {
        unfinished.remove(request);
        assembles = isAssembling();
      }
    } else if (head[TYPE] == REQUEST || fragmentedRequests.contains(request)) {
      refuse(request, length);
    } else {
      id.putInt(request);
      headPassing = head.length;
      bodyBytes = length - ID_BYTES;
      takeIfLarge(length);
    }
  }

  /** Lets the ORB have the beginning of a request that is too large, as if it were all. */
  private void refuse(int request, long length) throws IOException {
    long size = length + fragmented.getOrDefault(request, 0L);
    if (refused.size() >= MOST_FRAGMENTED) {
      throw new IOException(refused.size() + " requests that are too large wait for their answers");
    }
    refused.put(request, size);
    if (unfinished.isEmpty()) {
      droppedInAll = 0;
    }
    if (hasMore()) {
      unfinished.add(request);
      assembles = true;
    }
    int passed = head[TYPE] == REQUEST ? (int) Math.min(length, BEGINNING_BYTES) : ID_BYTES;
    head[FLAGS] = (byte) (head[FLAGS] & ~MORE_FRAGMENTS);
    ByteBuffer.wrap(head).order(order()).putInt(LENGTH, passed);
    id.putInt(request);
    headPassing = head.length;
    bodyBytes = (long) passed - ID_BYTES;
    droppedBytes = length - passed;
  }

  /**
   * Returns the size of a request that was too large, of which the ORB has the beginning alone; 0
   * if it has all. The answer is forgotten.
   *
   * @param request its id
   */
  long takeRefused(int request) {
    Long size = refused.remove(request);
    return size == null ? 0 : size;
  }

  private void takeIfLarge(long bytes) throws IOException {
    // LimitedBuffers refuses messages above the largest size.
    if (bytes > LARGE_BYTES && bytes <= LimitedBuffers.MAX_MESSAGE_BYTES) {
      take(bytes);
      takenForMessage = bytes;
    }
  }

  /** A message is complete. */
  private void end() throws IOException {
    giveBack(takenForMessage);
    takenForMessage = 0;
    if (isMessage()) {
      used = true;
    }
    begunAt = 0;
    if (!id.hasRemaining() && (hasMore() || head[TYPE] == FRAGMENT)) {
      addFragment(id.getInt(0), hasMore());
    }
  }

  /** Bounds what the ORB has put together of fragments, like a message that comes whole. */
  private void addFragment(int request, boolean more) throws IOException {
    if (!more) {
      Long together = fragmented.remove(request);
      fragmentedRequests.remove(request);
      giveBack(together == null ? 0 : together);
      assembles = isAssembling();
      return;
    }
    assembles = true;
    take(announced);
    if (head[TYPE] == REQUEST) {
      fragmentedRequests.add(request);
    }
    fragmented.merge(request, announced, Long::sum);
    long all = together();
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

  private boolean isAssembling() {
    return !fragmented.isEmpty() || !unfinished.isEmpty();
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
   * begun. Bytes that have arrived and are not read yet are no fault of the peer. A connection that
   * nobody reads any more counts as late, too.
   *
   * @param now the time, ns, as {@link System#nanoTime}
   */
  boolean isOverdue(long now) {
    Thread last = reader;
    if (last != null && !last.isAlive()) {
      return true;
    }
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
