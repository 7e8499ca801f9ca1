package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The input of one connection that is not encrypted. Reads the headers of messages as they pass
 * (OMG, CORBA 3.0, section 15.4.1), to know of large ones before memory for them is taken.
 */
final class RequestStream extends InputStream {
  private static final Logger LOG = LoggerFactory.getLogger(RequestStream.class);
  private static final int HEADER_BYTES = 12;
  private static final int FLAGS = 6;
  private static final int LENGTH = 8;

  /** Smaller messages need no room: there are not so many connections. */
  private static final int LARGE_BYTES = 1 << 16;

  private final Socket socket;
  private final InputStream in;
  private final RequestMemory room;
  private final byte[] header = new byte[HEADER_BYTES];
  private int headerBytes;
  private long bodyBytes;
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
      bodyBytes -= passed;
      if (bodyBytes == 0) {
        giveBack();
      }
      return passed;
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
    bodyBytes = Math.max(0, ByteBuffer.wrap(header).order(order).getInt(LENGTH));
    // LimitedBuffers refuses messages above the largest size.
    if (bodyBytes > LARGE_BYTES && bodyBytes <= LimitedBuffers.MAX_MESSAGE_BYTES) {
      take(bodyBytes);
    }
  }

  private void take(long bytes) throws IOException {
    if (!room.take(this, bytes)) {
      throw new IOException("no room for a message of " + bytes + " bytes");
    }
    boolean tooLate;
    synchronized (this) {
      tooLate = closed;
      taken = tooLate ? 0 : bytes;
    }
    if (tooLate) {
      room.giveBack(this, bytes);
    }
  }

  private void giveBack() {
    long bytes;
    synchronized (this) {
      bytes = taken;
      taken = 0;
    }
    if (bytes > 0) {
      room.giveBack(this, bytes);
    }
  }

  /** Returns how long nothing has come, ns. */
  long stalledNanos() {
    return System.nanoTime() - movedAt;
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
    giveBack();
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
