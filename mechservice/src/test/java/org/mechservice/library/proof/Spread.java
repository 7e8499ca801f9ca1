package org.mechservice.library.proof;

import java.util.Random;

/** Random numbers, rounded to five digits, so that a model file shows what it has. */
final class Spread {
  private Spread() {}

  /** Returns a number between two bounds. */
  static double even(Random random, double low, double high) {
    return rounded(low + (high - low) * random.nextDouble());
  }

  /** Returns a number between two positive bounds, each power of ten as likely as another. */
  static double log(Random random, double low, double high) {
    return rounded(low * Math.pow(high / low, random.nextDouble()));
  }

  /** Returns one of some values. */
  @SafeVarargs
  static <T> T one(Random random, T... values) {
    return values[random.nextInt(values.length)];
  }

  static double rounded(double value) {
    return Double.parseDouble(String.format(java.util.Locale.ROOT, "%.4e", value));
  }
}
