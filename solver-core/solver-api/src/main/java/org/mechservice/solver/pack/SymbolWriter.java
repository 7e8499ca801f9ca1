package org.mechservice.solver.pack;

import java.io.ByteArrayOutputStream;
import java.io.IOException;

/**
 * Writes symbols by arithmetic coding: the numbers from {@code low} to {@code high} are divided
 * between 0 and 1 as their probabilities are; what the ends have in common is written.
 */
final class SymbolWriter extends Symbols {
  private static final int TOP = 24;
  private static final long ALL = 0xffffffffL;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private long low;
  private long high = ALL;

  @Override
  int bit(int one, int bit) throws IOException {
    long middle = low + (((high - low) * one) >>> 16);
    if (bit == 1) {
      high = middle;
    } else {
      low = middle + 1;
    }
    while (((low ^ high) >>> TOP) == 0) {
      out.write((int) (high >>> TOP));
      low = (low << Byte.SIZE) & ALL;
      high = ((high << Byte.SIZE) & ALL) | 0xff;
    }
    return bit;
  }

  /** Returns all that was written. */
  byte[] bytes() {
    for (int i = TOP; i >= 0; i -= Byte.SIZE) {
      out.write((int) (high >>> i));
    }
    return out.toByteArray();
  }
}
