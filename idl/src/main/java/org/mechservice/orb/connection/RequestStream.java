package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
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

  /** Place of the response flags in the body of a request (OMG, CORBA 3.0, section 15.4.2.1). */
  private static final int RESPONSE_FLAGS = MessageHead.ID_BYTES;

  private static final Set<Byte> KNOWN_RESPONSES = Set.of((byte) 0, (byte) 1, (byte) 3);

  /** Fragmented messages, or refused requests that are not answered yet, of one connection. */
  private static final int MOST_FRAGMENTED = 100;

  /**
   * Beginning of a request that is too large that the ORB gets: with the object and the operation,
   * B.
   */
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
  private final ConnectionRoom room;
  private final MessageHead head = new MessageHead();

  /** Bytes of the body that the ORB has got, and is still to get. */
  private long bodyPassed;

  private long bodyBytes;

  /** The thread that reads; it dies of messages that the ORB cannot read. */
  private volatile @Nullable Thread reader;

  /** Bytes that are thrown away after that. */
  private long droppedBytes;

  private final ByteBuffer id = ByteBuffer.allocate(MessageHead.ID_BYTES);

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

  /** Room of the message that arrives, B. */
  private long takenForMessage;

  private volatile long movedAt = System.nanoTime();

  RequestStream(Socket socket, InputStream in, RequestMemory memory) {
    this.socket = socket;
    this.in = in;
    room = new ConnectionRoom(memory, this);
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
    while (!head.isPassing() && bodyBytes == 0) {
      if (droppedBytes > 0 ? !drop() : !readHead()) {
        return -1;
      }
    }
    return head.isPassing() ? head.pass(bytes, start, length) : pass(bytes, start, length);
  }

  private int receive(byte[] bytes, int start, int length) throws IOException {
    reader = Thread.currentThread();
    int count = in.read(bytes, start, length);
    movedAt = System.nanoTime();
    return count;
  }

  /** Reads some of a head, and decides about the message if that is enough; false: at the end. */
  private boolean readHead() throws IOException {
    int count = receive(head.bytes, head.count(), head.missing());
    if (count < 0) {
      return false;
    }
    if (head.count() == 0) {
      begunAt = movedAt;
    }
    head.arrived(count);
    if (head.missing() == 0) {
      begin();
    }
    return true;
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
    if (head.isCurrent() && head.isRequest() && !KNOWN_RESPONSES.contains(flags)) {
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

  private void begin() throws IOException {
    long length = head.length();
    if (length < 0) {
      throw new IOException("a message whose length is negative");
    }
    if (!head.hasId() && concernsRefused(length)) {
      head.awaitId();
      return;
    }
    announced = length;
    bodyPassed = (long) head.count() - MessageHead.HEADER_BYTES;
    id.clear().order(head.order());
    if (head.hasId()) {
      beginWithId(length);
    } else {
      head.letPass(MessageHead.HEADER_BYTES);
      bodyBytes = length;
      takeIfLarge(length);
    }
    head.end();
    endIfComplete();
  }

  /** Returns whether a message belongs to a request that is, or has been found to be, too large. */
  private boolean concernsRefused(long length) {
    if (!head.isCurrent() || length < MessageHead.ID_BYTES || length > MOST_DROPPED_BYTES) {
      return false;
    }
    if (head.isRequest()) {
      return length + (head.hasMore() ? together() : 0) > LimitedBuffers.MAX_MESSAGE_BYTES;
    }
    return head.isFragment()
        && (!unfinished.isEmpty()
            || (!fragmentedRequests.isEmpty()
                && length + together() > LimitedBuffers.MAX_MESSAGE_BYTES));
  }

  private long together() {
    return fragmented.values().stream().mapToLong(Long::longValue).sum();
  }

  private void beginWithId(long length) throws IOException {
    int request = head.requestId();
    if (head.isFragment() && unfinished.contains(request)) {
      head.letPass(0);
      droppedBytes = length - MessageHead.ID_BYTES;
      if (!head.hasMore()) {
        unfinished.remove(request);
        assembles = isAssembling();
      }
    } else if (head.isRequest() || fragmentedRequests.contains(request)) {
      refuse(request, length);
    } else {
      id.putInt(request);
      head.letPass(head.bytes.length);
      bodyBytes = length - MessageHead.ID_BYTES;
      takeIfLarge(length);
    }
  }

  /** Passes the beginning of a request that is too large to the ORB, as if it were all. */
  private void refuse(int request, long length) throws IOException {
    long size = length + fragmented.getOrDefault(request, 0L);
    if (refused.size() >= MOST_FRAGMENTED) {
      throw new IOException(refused.size() + " requests that are too large wait for their answers");
    }
    refused.put(request, size);
    if (unfinished.isEmpty()) {
      droppedInAll = 0;
    }
    if (head.hasMore()) {
      unfinished.add(request);
      assembles = true;
    }
    int passed = head.isRequest() ? (int) Math.min(length, BEGINNING_BYTES) : MessageHead.ID_BYTES;
    head.cutTo(passed);
    id.putInt(request);
    head.letPass(head.bytes.length);
    bodyBytes = (long) passed - MessageHead.ID_BYTES;
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
      room.take(bytes);
      takenForMessage = bytes;
    }
  }

  /** A message is complete. */
  private void end() throws IOException {
    room.giveBack(takenForMessage);
    takenForMessage = 0;
    if (head.isMessage()) {
      used = true;
    }
    begunAt = 0;
    if (!id.hasRemaining() && (head.hasMore() || head.isFragment())) {
      addFragment(id.getInt(0), head.hasMore());
    }
  }

  /** Bounds what the ORB has put together of fragments, like a message that comes whole. */
  private void addFragment(int request, boolean more) throws IOException {
    if (!more) {
      Long together = fragmented.remove(request);
      fragmentedRequests.remove(request);
      room.giveBack(together == null ? 0 : together);
      assembles = isAssembling();
      return;
    }
    assembles = true;
    room.take(announced);
    if (head.isRequest()) {
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
   * begun. Bytes that have arrived and are not read yet are no fault of the peer. A connection
   * whose reading thread has ended counts as late, too.
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
    room.end();
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
