package org.mechservice.solver.pack;

import java.io.IOException;

/** Reads what a {@link SymbolWriter} wrote. */
final class SymbolReader extends Symbols {
  private static final int TOP = 24;
  private static final long ALL = 0xffffffffL;

  /** No solver has more bits: what claims to is damaged. */
  private static final int MOST_BITS = 1 << 27;

  private final byte[] packed;
  private int bits;
  private int next;
  private long low;
  private long high = ALL;
  private long at;

  SymbolReader(byte[] packed) throws IOException {
    this.packed = packed;
    for (int i = 0; i < Integer.BYTES; i++) {
      at = (at << Byte.SIZE) | nextByte();
    }
  }

  private int nextByte() throws IOException {
    if (next == packed.length) {
      throw new IOException("the packed classes end too early");
    }
    return packed[next++] & 0xff;
  }

  @Override
  int bit(int one, int bit) throws IOException {
    if (++bits > MOST_BITS) {
      throw new IOException("the packed classes are damaged");
    }
    long middle = low + (((high - low) * one) >>> 16);
    int read = at <= middle ? 1 : 0;
    if (read == 1) {
      high = middle;
    } else {
      low = middle + 1;
    }
    while (((low ^ high) >>> TOP) == 0) {
      low = (low << Byte.SIZE) & ALL;
      high = ((high << Byte.SIZE) & ALL) | 0xff;
      at = ((at << Byte.SIZE) & ALL) | nextByte();
    }
    return read;
  }
}
