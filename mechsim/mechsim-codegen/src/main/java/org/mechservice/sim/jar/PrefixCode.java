package org.mechservice.sim.jar;

import java.util.Arrays;
import java.util.stream.IntStream;

/** The shortest prefix code whose words have no more than a given number of bits. */
final class PrefixCode {
  private final int[] lengths;
  private final int[] words;

  private PrefixCode(int[] lengths) {
    this.lengths = lengths;
    this.words = words(lengths);
  }

  /**
   * Returns the code of some symbols (package-merge, Larmore and Hirschberg, J. ACM 37, 1990).
   *
   * @param counts how often each symbol occurs; one that does not has no word
   * @param most bits of the longest word
   */
  static PrefixCode of(int[] counts, int most) {
    int[] symbols =
        IntStream.range(0, counts.length)
            .filter(symbol -> counts[symbol] > 0)
            .boxed()
            .sorted((a, b) -> counts[a] != counts[b] ? counts[a] - counts[b] : a - b)
            .mapToInt(Integer::intValue)
            .toArray();
    int[] lengths = new int[counts.length];
    if (symbols.length == 1) {
      lengths[symbols[0]] = 1;
    } else if (symbols.length > 1) {
      long[] leaves = Arrays.stream(symbols).mapToLong(symbol -> counts[symbol]).toArray();
      int[] sorted = merged(leaves, most);
      for (int i = 0; i < symbols.length; i++) {
        lengths[symbols[i]] = sorted[i];
      }
    }
    return new PrefixCode(lengths);
  }

  /** Returns the code with words of given lengths. */
  static PrefixCode withLengths(int[] lengths) {
    return new PrefixCode(lengths.clone());
  }

  /**
   * @param leaves ascending
   * @return the length of each word
   */
  private static int[] merged(long[] leaves, int most) {
    boolean[][] isLeaf = new boolean[most][];
    long[] level = {};
    for (int bits = 0; bits < most; bits++) {
      int packages = level.length / 2;
      long[] next = new long[leaves.length + packages];
      isLeaf[bits] = new boolean[next.length];
      int leaf = 0;
      int pair = 0;
      for (int i = 0; i < next.length; i++) {
        boolean takesLeaf =
            pair == packages
                || (leaf < leaves.length && leaves[leaf] <= level[2 * pair] + level[2 * pair + 1]);
        isLeaf[bits][i] = takesLeaf;
        next[i] = takesLeaf ? leaves[leaf++] : level[2 * pair] + level[2 * pair + 1];
        pair += takesLeaf ? 0 : 1;
      }
      level = next;
    }
    int[] lengths = new int[leaves.length];
    int taken = 2 * leaves.length - 2;
    for (int bits = most - 1; bits >= 0; bits--) {
      int leaf = 0;
      for (int i = 0; i < taken; i++) {
        leaf += isLeaf[bits][i] ? 1 : 0;
      }
      for (int i = 0; i < leaf; i++) {
        lengths[i]++;
      }
      taken = 2 * (taken - leaf);
    }
    return lengths;
  }

  /** Words of one length follow each other in the order of their symbols (RFC 1951, 3.2.2). */
  private static int[] words(int[] lengths) {
    int[] words = new int[lengths.length];
    int word = 0;
    for (int bits = 1; bits <= 15; bits++) {
      word <<= 1;
      for (int symbol = 0; symbol < lengths.length; symbol++) {
        if (lengths[symbol] == bits) {
          words[symbol] = Integer.reverse(word) >>> (32 - bits);
          word++;
        }
      }
    }
    return words;
  }

  /** Returns the bits of a symbol's word; 0 if it has none. */
  int length(int symbol) {
    return lengths[symbol];
  }

  /** Returns the number of symbols up to the last that has a word. */
  int used() {
    int used = lengths.length;
    while (used > 0 && lengths[used - 1] == 0) {
      used--;
    }
    return used;
  }

  /** Writes a symbol. */
  void write(int symbol, BitSink out) {
    out.write(words[symbol], lengths[symbol]);
  }
}
