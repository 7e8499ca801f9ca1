package org.mechservice.report.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The wall-clock time that a report may take, and what it left out to keep it. Every part of a
 * report asks what is left before it begins, compares it with its own forecast, and tells here in a
 * sentence what it does not do.
 */
public final class ReportBudget {
  /** Thirty years stand for no bound, so that differences of times are numbers. */
  private static final double NO_BOUND = 1e9;

  private final double seconds;
  private final long started = System.nanoTime();
  private final List<String> savings = new ArrayList<>();

  /**
   * Starts a budget now.
   *
   * @param seconds for the whole report, s; infinite for no bound
   */
  public ReportBudget(double seconds) {
    this.seconds = Math.min(seconds, NO_BOUND);
  }

  /** Returns the time for the whole report, s. */
  public double seconds() {
    return seconds;
  }

  /** Returns what is left, s; not negative. */
  public double left() {
    return Math.max(0, seconds - (System.nanoTime() - started) * 1e-9);
  }

  /** Adds a sentence about what the report leaves out to keep its time. */
  public void saves(String sentence) {
    savings.add(sentence);
  }

  /** Returns a sentence for each thing that was left out to keep the time. */
  public List<String> savings() {
    return List.copyOf(savings);
  }

  /** Returns a time of the report in words: milliseconds, seconds or minutes. */
  public static String inWords(double seconds) {
    if (seconds < 0.1) {
      return String.format(Locale.ROOT, "%.0f ms", Math.max(1, 1000 * seconds));
    }
    return seconds < 120
        ? plain(seconds) + " s"
        : String.format(Locale.ROOT, "%s minutes", plain(seconds / 60));
  }

  /** Two or three digits, and none behind the point that say nothing: 3 and not 3.00. */
  private static String plain(double value) {
    double shown = value < 10 ? Math.rint(value * 10) / 10 : Math.rint(value);
    return shown == Math.rint(shown) || value >= 10
        ? String.format(Locale.ROOT, "%.0f", shown)
        : String.format(Locale.ROOT, "%.1f", shown);
  }
}
