package org.mechservice.sim.jar;

import java.util.Arrays;

/**
 * Where the bytes at each place of a file have occurred before: for each length that can be copied
 * from the nearest place that has it.
 */
final class RepeatedBytes {
  static final int SHORTEST = 3;
  static final int LONGEST = 258;
  private static final int WINDOW = 1 << 15;

  /** Places looked at for one; beyond that nothing is found that is worth the time. */
  private static final int MOST_TRIES = 2048;

  private static final int HASH_BITS = 15;

  private final byte[] content;
  private final int[] previous;
  private final int[] firstOf;
  private int[] found = new int[1024];
  private int count;

  RepeatedBytes(byte[] content) {
    this.content = content;
    previous = new int[content.length];
    firstOf = new int[content.length + 1];
    int[] last = new int[1 << HASH_BITS];
    Arrays.fill(last, -1);
    for (int at = 0; at < content.length; at++) {
      firstOf[at] = count;
      if (at + SHORTEST <= content.length) {
        int hash = hash(at);
        previous[at] = last[hash];
        last[hash] = at;
        find(at);
      }
    }
    firstOf[content.length] = count;
  }

  private int hash(int at) {
    int three =
        (content[at] & 0xff) << 16 | (content[at + 1] & 0xff) << 8 | (content[at + 2] & 0xff);
    return (three * 0x9E3779B1) >>> (32 - HASH_BITS);
  }

  private void find(int at) {
    int best = SHORTEST - 1;
    int limit = Math.min(LONGEST, content.length - at);
    int tries = 0;
    for (int from = previous[at];
        from >= 0 && at - from <= WINDOW && tries < MOST_TRIES && best < limit;
        from = previous[from]) {
      tries++;
      if (content[from + best] == content[at + best]) {
        int length = Arrays.mismatch(content, from, from + limit, content, at, at + limit);
        int equal = length < 0 ? limit : length;
        if (equal > best) {
          best = equal;
          add(equal, at - from);
        }
      }
    }
  }

  private void add(int length, int distance) {
    if (count == found.length) {
      found = Arrays.copyOf(found, 2 * count);
    }
    found[count++] = length << 16 | distance - 1;
  }

  /** Returns where what is found for a place begins; it ends where that for the next begins. */
  int first(int at) {
    return firstOf[at];
  }

  /** Returns how many bytes can be copied; ascending for one place. */
  int length(int index) {
    return found[index] >>> 16;
  }

  /** Returns how far back they lie. */
  int distance(int index) {
    return (found[index] & 0xffff) + 1;
  }
}
