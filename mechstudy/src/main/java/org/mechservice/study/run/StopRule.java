package org.mechservice.study.run;

/**
 * The conditions that end a study before its last point.
 *
 * @param failures number of failing points; 0 if any number may fail
 * @param output index of the output whose mean is watched; -1 if none is
 * @param error standard error of this mean below which the study ends
 */
record StopRule(int failures, int output, double error) {
  static final StopRule NONE = new StopRule(0, -1, 0);

  /** Fewer values say nothing about their spread. */
  private static final int LEAST_VALUES = 30;

  boolean ends(StudyStatistics seen) {
    return (failures > 0 && seen.failed() >= failures)
        || (output >= 0
            && seen.count(output) >= LEAST_VALUES
            && seen.standardError(output) < error);
  }
}
