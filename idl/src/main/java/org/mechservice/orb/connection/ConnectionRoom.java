package org.mechservice.orb.connection;

import java.io.IOException;

/**
 * The room that messages of one connection have in {@link RequestMemory}. What is taken when the
 * connection ends is given back then, and nothing is taken after that. May be used by several
 * threads.
 */
final class ConnectionRoom {
  private final RequestMemory memory;
  private final RequestStream connection;
  private long taken;
  private boolean ended;

  ConnectionRoom(RequestMemory memory, RequestStream connection) {
    this.memory = memory;
    this.connection = connection;
  }

  /**
   * Takes room for a message.
   *
   * @throws IOException if there is none
   */
  void take(long bytes) throws IOException {
    if (!memory.take(connection, bytes)) {
      throw new IOException("no room for a message of " + bytes + " bytes");
    }
    boolean tooLate;
    synchronized (this) {
      tooLate = ended;
      taken += tooLate ? 0 : bytes;
    }
    if (tooLate) {
      memory.giveBack(connection, bytes);
    }
  }

  /** Gives room back, no more than has been taken. */
  void giveBack(long most) {
    long bytes;
    synchronized (this) {
      bytes = Math.min(most, taken);
      taken -= bytes;
    }
    if (bytes > 0) {
      memory.giveBack(connection, bytes);
    }
  }

  /** Gives all room back for good. */
  void end() {
    synchronized (this) {
      ended = true;
    }
    giveBack(Long.MAX_VALUE);
  }
}
