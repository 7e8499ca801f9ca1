package org.mechservice.study.run;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;

/**
 * Prints after a minute, and then every five, how long a study will take: by the time of the points
 * that this process has finished.
 *
 * <p>Thread-safe.
 */
public final class StudyForecast implements Study.Progress {
  private static final double FIRST_WORD_SECONDS = 60;
  private static final double NEXT_WORD_SECONDS = 300;

  private final DoubleSupplier clock;
  private final int all;
  private final double begun;
  private double next = FIRST_WORD_SECONDS;
  private int done;
  private int before;

  /**
   * @param clock seconds from any moment on
   * @param all points of the study or its part
   */
  public StudyForecast(DoubleSupplier clock, int all) {
    this.clock = clock;
    this.all = all;
    begun = clock.getAsDouble();
  }

  @Override
  public synchronized void at(int doneNow, int beforeThis, int ofAll) {
    done = doneNow;
    before = beforeThis;
  }

  /** Returns what is to be said now; to be asked every second or so. */
  public synchronized Optional<String> word() {
    double seconds = clock.getAsDouble() - begun;
    if (seconds < next || done >= all) {
      return Optional.empty();
    }
    next = seconds + NEXT_WORD_SECONDS;
    String so = done + " of " + all + " points";
    if (done <= before) {
      return Optional.of(
          so + " after " + duration(seconds) + "; none of this process is finished yet");
    }
    return Optional.of(
        so + "; about " + duration(seconds / (done - before) * (all - done)) + " left");
  }

  private static String duration(double seconds) {
    if (seconds < 120) {
      return Math.round(seconds) + " s";
    }
    double minutes = seconds / 60;
    if (minutes < 120) {
      return Math.round(minutes) + " min";
    }
    double hours = minutes / 60;
    return hours < 48
        ? String.format(Locale.ROOT, "%.1f h", hours)
        : Math.round(hours / 24) + " days";
  }
}
