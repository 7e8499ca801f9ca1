package org.mechservice.report.measure;

/** Receives the progress of a report. */
public interface ReportProgress {
  /** Ignores the progress. */
  ReportProgress SILENT = (what, done, secondsLeft) -> {};

  /**
   * Reports what is being measured. What it throws ends the report; measurements are kept.
   *
   * @param what the current work, in a few words
   * @param done part of the whole, from 0 to 1
   * @param secondsLeft estimated, s; NaN if not known yet
   */
  void at(String what, double done, double secondsLeft);
}
