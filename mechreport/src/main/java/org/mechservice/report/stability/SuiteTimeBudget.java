package org.mechservice.report.stability;

import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * Time for the runs of a suite: none takes longer than a limit and, if that is asked for, all
 * together take no longer than a total. Cases have equal shares of it, and so have the runs of a
 * case; what one leaves goes to those after it. Models are built on top of that.
 */
public final class SuiteTimeBudget {
  private static final double PER_NANOSECOND = 1e-9;

  private final double limitSeconds;
  private final double totalSeconds;
  private final LongSupplier nanoTime;
  private final long started;
  private double endOfCase;

  /**
   * Begins now.
   *
   * @param limitSeconds for one run, s
   * @param totalSeconds for all runs, s; infinite: only the limit counts
   */
  public SuiteTimeBudget(double limitSeconds, double totalSeconds) {
    this(limitSeconds, totalSeconds, System::nanoTime);
  }

  public SuiteTimeBudget(double limitSeconds, double totalSeconds, LongSupplier nanoTime) {
    this.limitSeconds = limitSeconds;
    this.totalSeconds = totalSeconds;
    this.nanoTime = nanoTime;
    started = nanoTime.getAsLong();
    endOfCase = totalSeconds;
  }

  /** Returns the time since the start, s. */
  double elapsed() {
    return (nanoTime.getAsLong() - started) * PER_NANOSECOND;
  }

  /** Begins a case; as many are left with it. */
  void beginCase(int casesLeft) {
    double now = elapsed();
    endOfCase = now + (totalSeconds - now) / casesLeft;
  }

  /** Returns the time for a run of the case, s; as many are left with it. */
  double forRun(int runsLeft) {
    return Math.min(limitSeconds, Math.max(0, (endOfCase - elapsed()) / runsLeft));
  }

  /** Returns a sentence about stopped runs. */
  String sentence() {
    return Double.isFinite(totalSeconds)
        ? String.format(
            Locale.ROOT,
            "Runs were stopped after %.3g s, or sooner to end all within %.3g s.",
            limitSeconds,
            totalSeconds)
        : String.format(Locale.ROOT, "Runs were stopped after %.3g s.", limitSeconds);
  }
}
