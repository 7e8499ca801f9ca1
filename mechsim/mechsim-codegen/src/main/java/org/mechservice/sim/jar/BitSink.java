package org.mechservice.sim.jar;

import java.io.ByteArrayOutputStream;

/** Bits one after the other, the lowest of each byte first. */
final class BitSink {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private int open;
  private int count;

  /** Writes the lowest bits of a number, the lowest first; at most 16. */
  void write(int value, int bits) {
    open |= value << count;
    count += bits;
    while (count >= 8) {
      bytes.write(open);
      open >>>= 8;
      count -= 8;
    }
  }

  /** Fills the last byte with zeros and returns all. */
  byte[] bytes() {
    if (count > 0) {
      write(0, 8 - count);
    }
    return bytes.toByteArray();
  }
}
