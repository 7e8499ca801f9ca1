package org.mechservice.client.sweep;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The result of one point of a grid.
 *
 * @param point its number
 * @param outcome {@code completed}, {@code failed} or {@code stopped}
 * @param code entry of the error catalogue; empty unless it failed
 * @param message why it failed, one line; empty unless it did
 * @param values last row of the run, one number per column; empty if there is none
 * @param report the run report; empty if there is none
 */
public record SweepRow(
    int point,
    String outcome,
    String code,
    String message,
    List<Double> values,
    Map<String, Object> report) {
  /** Outcome of a run that reached its end. */
  public static final String COMPLETED = "completed";

  /** Outcome of a run that failed, or could not start with these values. */
  public static final String FAILED = "failed";

  /** Outcome of a run that was stopped on request. */
  public static final String STOPPED = "stopped";

  public SweepRow {
    values = List.copyOf(values);
    report = Collections.unmodifiableMap(new LinkedHashMap<>(report));
  }

  static SweepRow failed(
      int point, String code, String message, double[] last, Map<String, Object> report) {
    return new SweepRow(point, FAILED, code, message, boxed(last), report);
  }

  static List<Double> boxed(double[] row) {
    return Arrays.stream(row).boxed().toList();
  }
}
