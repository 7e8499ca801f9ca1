package org.mechservice.sim.jar;

import java.util.Arrays;

/** The codes of one block with what tells them (RFC 1951, 3.2.6 and 3.2.7). */
final class DeflateBlock {
  private static final int LONGEST_WORD = 15;
  private static final int LENGTH_CODES = 19;
  private static final int LONGEST_LENGTH_WORD = 7;
  private static final int LEAST_LITERALS = 257;
  private static final int[] ORDER = {
    16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15
  };

  /** Symbols that repeat a length: what they repeat at least and at most, and their extra bits. */
  private static final int REPEAT = 16;

  private static final int SHORT_ZEROS = 17;
  private static final int LONG_ZEROS = 18;

  private final int[] literalCounts = new int[Tokens.LITERALS];
  private final int[] distanceCounts = new int[Tokens.DISTANCES];
  private final boolean fixed;
  private final PrefixCode literals;
  private final PrefixCode distances;

  /** The lengths of all words: a symbol, with what it repeats beyond its least above it. */
  private final int[] lengths;

  private int lengthCount;
  private final PrefixCode lengthCode;
  private final long bits;

  /** Codes for tokens {@code from} to {@code to}. */
  DeflateBlock(Tokens tokens, int from, int to) {
    tokens.count(from, to, literalCounts, distanceCounts);
    PrefixCode ownLiterals = PrefixCode.of(literalCounts, LONGEST_WORD);
    PrefixCode ownDistances = PrefixCode.of(distanceCounts, LONGEST_WORD);
    lengths = new int[Tokens.LITERALS + Tokens.DISTANCES];
    lengthCode = tell(ownLiterals, ownDistances);
    long own = headBits() + bodyBits(ownLiterals, ownDistances);
    PrefixCode fixedLiterals = PrefixCode.withLengths(fixedLengths());
    PrefixCode fixedDistances = PrefixCode.withLengths(fiveEach());
    long known = 3 + bodyBits(fixedLiterals, fixedDistances);
    fixed = known <= own;
    literals = fixed ? fixedLiterals : ownLiterals;
    distances = fixed ? fixedDistances : ownDistances;
    bits = Math.min(own, known);
  }

  private static int[] fixedLengths() {
    int[] fixed = new int[288];
    for (int symbol = 0; symbol < fixed.length; symbol++) {
      fixed[symbol] = symbol < 144 ? 8 : symbol < 256 ? 9 : symbol < 280 ? 7 : 8;
    }
    return fixed;
  }

  private static int[] fiveEach() {
    int[] five = new int[32];
    Arrays.fill(five, 5);
    return five;
  }

  /** Returns how many bits the block takes. */
  long bits() {
    return bits;
  }

  int[] literalCounts() {
    return literalCounts;
  }

  int[] distanceCounts() {
    return distanceCounts;
  }

  private static int literalsTold(PrefixCode literals) {
    return Math.max(LEAST_LITERALS, literals.used());
  }

  private static int distancesTold(PrefixCode distances) {
    return Math.max(1, distances.used());
  }

  private PrefixCode tell(PrefixCode ownLiterals, PrefixCode ownDistances) {
    int first = literalsTold(ownLiterals);
    int all = first + distancesTold(ownDistances);
    int[] told = new int[all];
    for (int i = 0; i < all; i++) {
      told[i] = i < first ? ownLiterals.length(i) : ownDistances.length(i - first);
    }
    int[] counts = new int[LENGTH_CODES];
    for (int i = 0; i < all; ) {
      int run = 1;
      while (i + run < all && told[i + run] == told[i]) {
        run++;
      }
      i += run;
      tellRun(told[i - 1], run, counts);
    }
    return PrefixCode.of(counts, LONGEST_LENGTH_WORD);
  }

  private void tellRun(int length, int run, int[] counts) {
    int left = run;
    if (length == 0) {
      while (left >= 11) {
        int some = Math.min(left, 138);
        put(LONG_ZEROS, some - 11, counts);
        left -= some;
      }
      if (left >= 3) {
        put(SHORT_ZEROS, left - 3, counts);
        left = 0;
      }
    } else {
      put(length, 0, counts);
      left--;
      while (left >= 3) {
        // Seven as four and three: none is left to be told alone.
        int some = left == 7 ? 4 : Math.min(left, 6);
        put(REPEAT, some - 3, counts);
        left -= some;
      }
    }
    for (; left > 0; left--) {
      put(length, 0, counts);
    }
  }

  private void put(int symbol, int more, int[] counts) {
    lengths[lengthCount++] = more << 8 | symbol;
    counts[symbol]++;
  }

  private static int extra(int symbol) {
    return symbol == REPEAT ? 2 : symbol == SHORT_ZEROS ? 3 : symbol == LONG_ZEROS ? 7 : 0;
  }

  private int lengthCodesTold() {
    int told = LENGTH_CODES;
    while (told > 4 && lengthCode.length(ORDER[told - 1]) == 0) {
      told--;
    }
    return told;
  }

  private long headBits() {
    long sum = 3 + 5 + 5 + 4 + 3L * lengthCodesTold();
    for (int i = 0; i < lengthCount; i++) {
      int symbol = lengths[i] & 0xff;
      sum += lengthCode.length(symbol) + extra(symbol);
    }
    return sum;
  }

  private long bodyBits(PrefixCode withLiterals, PrefixCode withDistances) {
    long sum = 0;
    for (int symbol = 0; symbol < Tokens.LITERALS; symbol++) {
      sum +=
          (long) literalCounts[symbol] * (withLiterals.length(symbol) + Tokens.lengthExtra(symbol));
    }
    for (int symbol = 0; symbol < Tokens.DISTANCES; symbol++) {
      sum +=
          (long) distanceCounts[symbol]
              * (withDistances.length(symbol) + Tokens.distanceExtra(symbol));
    }
    return sum;
  }

  /** Writes the block with its tokens. */
  void write(Tokens tokens, boolean last, BitSink out) {
    out.write(last ? 1 : 0, 1);
    out.write(fixed ? 1 : 2, 2);
    if (!fixed) {
      out.write(literalsTold(literals) - LEAST_LITERALS, 5);
      out.write(distancesTold(distances) - 1, 5);
      int told = lengthCodesTold();
      out.write(told - 4, 4);
      for (int i = 0; i < told; i++) {
        out.write(lengthCode.length(ORDER[i]), 3);
      }
      for (int i = 0; i < lengthCount; i++) {
        int symbol = lengths[i] & 0xff;
        lengthCode.write(symbol, out);
        out.write(lengths[i] >>> 8, extra(symbol));
      }
    }
    tokens.write(literals, distances, out);
    literals.write(Tokens.END, out);
  }
}
