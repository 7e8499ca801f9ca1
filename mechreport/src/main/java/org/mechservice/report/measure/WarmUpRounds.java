package org.mechservice.report.measure;

import java.util.Locale;
import java.util.function.DoubleSupplier;

/**
 * Repeats rounds over all points until they get no faster: the JIT compiler has then compiled every
 * method.
 */
public final class WarmUpRounds {
  /** A block of rounds that is faster than the one before by no more than this ends the warm-up. */
  private static final double STEADY = 0.98;

  private static final int FEWEST_BLOCKS = 2;

  /** Beyond so many times the block's length a machine that is never steady is not waited for. */
  private static final double MOST_BLOCKS = 12;

  private WarmUpRounds() {}

  /**
   * Warms up.
   *
   * @param round runs every point once; returns the time it took, s
   * @param blockSeconds time of rounds that are compared with those before them, s
   * @param progress is called for every round
   * @param thenSeconds estimated time of the work after the warm-up, s
   */
  public static void until(
      DoubleSupplier round, double blockSeconds, ReportProgress progress, double thenSeconds) {
    double before = Double.POSITIVE_INFINITY;
    boolean steady = false;
    double spent = 0;
    for (int block = 0; block < FEWEST_BLOCKS || !steady; block++) {
      if (spent > MOST_BLOCKS * blockSeconds) {
        break;
      }
      Block done = block(round, blockSeconds, progress, thenSeconds, block);
      spent += done.seconds;
      steady = done.mean() >= STEADY * before;
      before = done.mean();
    }
  }

  private record Block(double seconds, int rounds) {
    double mean() {
      return seconds / rounds;
    }
  }

  private static Block block(
      DoubleSupplier round, double blockSeconds, ReportProgress progress, double then, int block) {
    double spent = 0;
    int rounds = 0;
    while (rounds == 0 || spent < blockSeconds) {
      String what = String.format(Locale.ROOT, "warming up, block %d", block + 1);
      double left = Math.max(0, FEWEST_BLOCKS - block) * blockSeconds - spent;
      progress.at(what, 0.3, Math.max(0, left) + then);
      spent += round.getAsDouble();
      rounds++;
    }
    return new Block(spent, rounds);
  }
}
