package org.mechservice.study.design;

/**
 * Random numbers by their place in a stream, above 0 and below 1: the generator SplitMix64 (Steele,
 * Lea and Flood, "Fast splittable pseudorandom number generators", 2014), whose state after n draws
 * is known without drawing.
 */
final class Uniform {
  private static final long GOLDEN = 0x9e3779b97f4a7c15L;
  private static final double STEP = 0x1p-53;

  private Uniform() {}

  /** Returns a number of the stream of a seed. */
  static double at(long seed, long place) {
    long bits = mixed(mixed(seed) + (place + 1) * GOLDEN);
    return inside((bits >>> 11) * STEP);
  }

  private static long mixed(long state) {
    long z = (state ^ (state >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  /** Returns a number of [0, 1) moved off its ends, where distributions are infinite. */
  static double inside(double u) {
    return Math.min(1 - STEP, Math.max(STEP, u));
  }
}
