package org.mechservice.report.measure;

/** Hears how far a report is. */
public interface ReportProgress {
  /** Tells nobody. */
  ReportProgress SILENT = (what, done, secondsLeft) -> {};

  /**
   * Tells what is being done.
   *
   * @param what in a few words
   * @param done part of the whole, from 0 to 1
   * @param secondsLeft estimated, s; NaN if not known yet
   */
  void at(String what, double done, double secondsLeft);
}
