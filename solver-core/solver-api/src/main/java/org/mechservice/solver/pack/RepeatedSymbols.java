package org.mechservice.solver.pack;

import java.util.Arrays;

/** Expects that what followed the last symbols when they came before will follow them again. */
final class RepeatedSymbols {
  private static final int LENGTH = 5;
  private static final int HASH_BITS = 18;
  static final int MOST_LENGTH = 15;

  /** Where a sequence of symbols was seen last: behind it. */
  private final int[] seen = new int[1 << HASH_BITS];

  /** Bands and symbols in the order in which they were carried, from 1. */
  private int[] symbols = new int[1 << HASH_BITS];

  private int count;
  private int candidate;
  private int length;

  /** Returns the symbol expected, or -1 if none is. */
  int expected(int band) {
    int next = symbols[candidate];
    return length > 0 && next >> Byte.SIZE == band ? next & 0xff : -1;
  }

  /** Returns for how many symbols, at most 15, the expectation was right. */
  int length() {
    return length;
  }

  void follow(int band, int symbol) {
    int entry = band << Byte.SIZE | symbol;
    if (length > 0 && symbols[candidate] == entry) {
      length = Math.min(length + 1, MOST_LENGTH);
      candidate++;
    } else {
      length = 0;
    }
    count++;
    if (count + 1 >= symbols.length) {
      symbols = Arrays.copyOf(symbols, 2 * symbols.length);
    }
    symbols[count] = entry;
    if (count >= LENGTH) {
      look();
    }
  }

  private void look() {
    int hash = 0;
    for (int i = 0; i < LENGTH; i++) {
      hash = Surroundings.hash(hash, symbols[count - i]);
    }
    int place = hash >>> (Integer.SIZE - HASH_BITS);
    if (length == 0) {
      candidate = seen[place];
      length = candidate == 0 ? 0 : 1;
    }
    seen[place] = count + 1;
  }
}
