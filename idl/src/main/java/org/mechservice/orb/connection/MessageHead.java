package org.mechservice.orb.connection;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * The head of a message: its header of 12 bytes, and the id of its request behind it where a
 * decision needs both (OMG, CORBA 3.0, section 15.4.1). It is filled as its bytes arrive, and
 * passed on once it has been decided what the ORB gets of the message. For one thread.
 */
final class MessageHead {
  static final int HEADER_BYTES = 12;

  /** A fragment and a message of version 1.2 begin with the id of their request. */
  static final int ID_BYTES = 4;

  private static final byte[] MAGIC = {'G', 'I', 'O', 'P'};
  private static final int MAJOR = 4;
  private static final int MINOR = 5;
  private static final int FLAGS = 6;
  private static final int MORE_FRAGMENTS = 2;
  private static final int TYPE = 7;
  private static final int REQUEST = 0;
  private static final int FRAGMENT = 7;
  private static final int LENGTH = 8;

  /** Header and id; bytes that arrive are written behind {@link #count}. */
  final byte[] bytes = new byte[HEADER_BYTES + ID_BYTES];

  private int count;
  private int wanted = HEADER_BYTES;
  private int passing;
  private int passed;

  /** Returns how many bytes have arrived. */
  int count() {
    return count;
  }

  /** Returns how many bytes are still to arrive before the message can be decided about. */
  int missing() {
    return wanted - count;
  }

  void arrived(int more) {
    count += more;
  }

  /** Waits for the id, too. */
  void awaitId() {
    wanted = bytes.length;
  }

  boolean hasId() {
    return count == bytes.length;
  }

  /** Ends the arrival: the next bytes are those of another message. */
  void end() {
    passed = 0;
    count = 0;
    wanted = HEADER_BYTES;
  }

  /** Decides how many bytes of the head the ORB gets. */
  void letPass(int many) {
    passing = many;
  }

  boolean isPassing() {
    return passed < passing;
  }

  /** Passes bytes on; returns how many. */
  int pass(byte[] to, int start, int length) {
    int many = Math.min(passing - passed, length);
    System.arraycopy(bytes, passed, to, start, many);
    passed += many;
    return many;
  }

  boolean isMessage() {
    return Arrays.equals(bytes, 0, MAGIC.length, MAGIC, 0, MAGIC.length);
  }

  /** Returns whether it is a message whose body begins with the id of its request. */
  boolean isCurrent() {
    return isMessage() && bytes[MAJOR] == 1 && bytes[MINOR] >= 2;
  }

  boolean isRequest() {
    return bytes[TYPE] == REQUEST;
  }

  boolean isFragment() {
    return bytes[TYPE] == FRAGMENT;
  }

  /** Returns whether fragments of the message follow. */
  boolean hasMore() {
    return (bytes[FLAGS] & MORE_FRAGMENTS) != 0;
  }

  ByteOrder order() {
    return (bytes[FLAGS] & 1) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
  }

  /** Returns the length of the body, B. */
  long length() {
    return ByteBuffer.wrap(bytes).order(order()).getInt(LENGTH);
  }

  int requestId() {
    return ByteBuffer.wrap(bytes).order(order()).getInt(HEADER_BYTES);
  }

  /** Makes a message of the beginning of one, as if it were all. */
  void cutTo(int length) {
    bytes[FLAGS] = (byte) (bytes[FLAGS] & ~MORE_FRAGMENTS);
    ByteBuffer.wrap(bytes).order(order()).putInt(LENGTH, length);
  }
}
