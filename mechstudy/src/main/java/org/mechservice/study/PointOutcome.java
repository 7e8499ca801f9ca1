package org.mechservice.study;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.solver.api.run.Failure;

/** The outcome of the run of one point. */
public sealed interface PointOutcome {
  /**
   * The run reached its end.
   *
   * @param values one number for each value of {@link PointModel#names}; NaN where there is none,
   *     such as a level that is never crossed
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Values(double[] values) implements PointOutcome {}

  /**
   * The model cannot be used with these values, or its run could not go on.
   *
   * @param code entry of the error catalogue
   * @param message one line that says why
   * @param time simulated time of the failure, s; NaN if the run did not begin
   */
  record Failed(String code, String message, double time) implements PointOutcome {
    /** Returns the outcome of a run that could not go on. */
    public static Failed of(Failure failure) {
      return new Failed(failure.code().code(), oneLine(failure.message()), failure.time());
    }

    static String oneLine(String text) {
      return Stream.of(text.split("\\R", -1)).map(String::strip).collect(Collectors.joining(" "));
    }
  }
}
