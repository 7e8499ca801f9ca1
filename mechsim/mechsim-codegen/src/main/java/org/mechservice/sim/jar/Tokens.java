package org.mechservice.sim.jar;

import java.util.Arrays;

/** A stretch of a file as single bytes and copies of what came before (RFC 1951, 3.2.5). */
final class Tokens {
  static final int LITERALS = 286;
  static final int DISTANCES = 30;
  static final int END = 256;
  private static final int[] LENGTH_SYMBOL = new int[RepeatedBytes.LONGEST + 1];
  private static final int[] LENGTH_BASE = new int[LITERALS];
  private static final int[] LENGTH_EXTRA = new int[LITERALS];

  static {
    int length = RepeatedBytes.SHORTEST;
    for (int symbol = END + 1; symbol < LITERALS; symbol++) {
      LENGTH_EXTRA[symbol] = symbol < 265 || symbol == 285 ? 0 : (symbol - 261) / 4;
      LENGTH_BASE[symbol] = symbol == 285 ? RepeatedBytes.LONGEST : length;
      for (int i = 0; i < 1 << LENGTH_EXTRA[symbol] && length <= RepeatedBytes.LONGEST; i++) {
        LENGTH_SYMBOL[length++] = symbol;
      }
    }
    LENGTH_SYMBOL[RepeatedBytes.LONGEST] = 285;
  }

  /** A byte, or length &lt;&lt; 16 with the distance. */
  private int[] tokens = new int[256];

  private int count;

  static int lengthSymbol(int length) {
    return LENGTH_SYMBOL[length];
  }

  static int lengthExtra(int symbol) {
    return LENGTH_EXTRA[symbol];
  }

  static int distanceSymbol(int distance) {
    if (distance <= 4) {
      return distance - 1;
    }
    int top = 31 - Integer.numberOfLeadingZeros(distance - 1);
    return 2 * top + (((distance - 1) >>> (top - 1)) & 1);
  }

  static int distanceExtra(int symbol) {
    return symbol < 4 ? 0 : symbol / 2 - 1;
  }

  private static int distanceBase(int symbol) {
    return symbol < 4 ? symbol + 1 : ((2 + symbol % 2) << (symbol / 2 - 1)) + 1;
  }

  private void add(int token) {
    if (count == tokens.length) {
      tokens = Arrays.copyOf(tokens, 2 * count);
    }
    tokens[count++] = token;
  }

  void addByte(int value) {
    add(value);
  }

  void addCopy(int length, int distance) {
    add(length << 16 | distance);
  }

  int size() {
    return count;
  }

  /** Returns how many bytes a token stands for. */
  int length(int index) {
    return Math.max(1, tokens[index] >>> 16);
  }

  /** Returns a part. */
  Tokens part(int from, int to) {
    Tokens part = new Tokens();
    part.tokens = Arrays.copyOfRange(tokens, from, Math.max(to, from + 1));
    part.count = to - from;
    return part;
  }

  /** Counts symbols, the end of a block among them. */
  void count(int from, int to, int[] literals, int[] distances) {
    Arrays.fill(literals, 0);
    Arrays.fill(distances, 0);
    literals[END] = 1;
    for (int i = from; i < to; i++) {
      int length = tokens[i] >>> 16;
      if (length == 0) {
        literals[tokens[i]]++;
      } else {
        literals[LENGTH_SYMBOL[length]]++;
        distances[distanceSymbol(tokens[i] & 0xffff)]++;
      }
    }
  }

  /** Writes the tokens. */
  void write(PrefixCode literals, PrefixCode distances, BitSink out) {
    for (int i = 0; i < count; i++) {
      int length = tokens[i] >>> 16;
      if (length == 0) {
        literals.write(tokens[i], out);
      } else {
        int symbol = LENGTH_SYMBOL[length];
        literals.write(symbol, out);
        out.write(length - LENGTH_BASE[symbol], LENGTH_EXTRA[symbol]);
        int distance = tokens[i] & 0xffff;
        int far = distanceSymbol(distance);
        distances.write(far, out);
        out.write(distance - distanceBase(far), distanceExtra(far));
      }
    }
  }
}
