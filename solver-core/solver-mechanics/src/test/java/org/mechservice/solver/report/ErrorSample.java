package org.mechservice.solver.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Errors of many seeds. */
final class ErrorSample {
  private final List<Entry> entries = new ArrayList<>();
  private int above;

  private record Entry(long seed, double error) {}

  /** Adds the error of a seed and what it may be. */
  void add(long seed, double error, double bound) {
    entries.add(new Entry(seed, error));
    above += error < bound ? 0 : 1;
  }

  /** Returns how many errors are at their bounds, beyond, or no numbers. */
  int above() {
    return above;
  }

  /** Returns median, 90 and 99 percent, the largest with its seed, and the count beyond bounds. */
  String cells() {
    entries.sort(Comparator.comparingDouble(Entry::error));
    Entry last = entries.get(entries.size() - 1);
    return String.format(
        Locale.ROOT,
        "%d | %.1e | %.1e | %.1e | %.1e (seed %d) | %d",
        entries.size(),
        quantile(0.5),
        quantile(0.9),
        quantile(0.99),
        last.error,
        last.seed,
        above);
  }

  private double quantile(double part) {
    return entries.get((int) Math.min(entries.size() - 1, part * entries.size())).error;
  }
}
