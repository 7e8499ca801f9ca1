package org.mechservice.report.measure;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.mechservice.report.solution.StateDistance;

/**
 * One run of one method at one tolerance.
 *
 * @param method name of the method
 * @param tolerance requested relative tolerance
 * @param round 0: the first, whose time is not counted; from 1: timed
 * @param cause why it did not reach the end; empty if it did
 * @param seconds processor time of the run, s
 * @param bytes allocated
 * @param steps accepted steps
 * @param rejected rejected steps
 * @param evaluations of right-hand side or residual
 * @param jacobians formed
 * @param factorisations of matrices
 * @param errors against the reference
 * @param energyDrift largest change of the energy, work deducted, as a part of the energy's own
 *     scale; NaN where the model does not know it
 * @param limits how many steps were rejected for the sake of a joint, by its name, most first
 */
public record MeasuredRun(
    String method,
    double tolerance,
    int round,
    String cause,
    double seconds,
    long bytes,
    long steps,
    long rejected,
    long evaluations,
    long jacobians,
    long factorisations,
    Errors errors,
    double energyDrift,
    Map<String, Long> limits) {

  /** Header of the file that {@link #line} writes lines of. */
  public static final String HEADER =
      "method,relative_tolerance,round,cause,seconds,bytes_allocated,steps,rejected_steps,"
          + "evaluations,jacobians,factorisations,error_at_end,largest_error,position_error,"
          + "velocity_error,multiplier_error,constraint_residual,energy_drift,rejected_for";

  private static final int FIELDS = 19;

  /**
   * Distances from the reference, in the sense of {@link StateDistance}; NaN if the run did not
   * reach the end.
   *
   * @param atEnd at the end
   * @param largest over time
   * @param ofPositions largest over time, positions alone
   * @param ofVelocities largest over time, velocities alone
   * @param ofMultipliers largest over time, of the forces that close loops; NaN without loops
   * @param residual how far loops were open at most, m; NaN without loops
   */
  public record Errors(
      double atEnd,
      double largest,
      double ofPositions,
      double ofVelocities,
      double ofMultipliers,
      double residual) {
    /** Of a run that did not reach the end. */
    public static final Errors NONE =
        new Errors(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
  }

  public MeasuredRun {
    limits = Collections.unmodifiableMap(new LinkedHashMap<>(limits));
  }

  /** Returns whether the run reached the end. */
  public boolean completed() {
    return cause.isEmpty();
  }

  /** Returns the record of a run that was not made. */
  static MeasuredRun notRun(String method, double tolerance, String cause) {
    return new MeasuredRun(
        method, tolerance, 0, cause, 0, 0, 0, 0, 0, 0, 0, Errors.NONE, Double.NaN, Map.of());
  }

  /** Returns the same run without its errors. */
  public MeasuredRun withoutErrors() {
    return failed(cause);
  }

  /** Returns the same run as one that does not count, for a cause. */
  MeasuredRun failed(String why) {
    return new MeasuredRun(
        method,
        tolerance,
        round,
        why,
        seconds,
        bytes,
        steps,
        rejected,
        evaluations,
        jacobians,
        factorisations,
        Errors.NONE,
        energyDrift,
        limits);
  }

  /** Returns the run as a line of a CSV file. */
  public String line() {
    return String.join(
        ",",
        method,
        Double.toString(tolerance),
        Integer.toString(round),
        quoted(cause),
        String.format(Locale.ROOT, "%.6e", seconds),
        Long.toString(bytes),
        Long.toString(steps),
        Long.toString(rejected),
        Long.toString(evaluations),
        Long.toString(jacobians),
        Long.toString(factorisations),
        shortened(errors.atEnd),
        shortened(errors.largest),
        shortened(errors.ofPositions),
        shortened(errors.ofVelocities),
        shortened(errors.ofMultipliers),
        shortened(errors.residual),
        shortened(energyDrift),
        quoted(
            limits.entrySet().stream()
                .map(limit -> limit.getKey() + ": " + limit.getValue())
                .collect(Collectors.joining("; "))));
  }

  private static String quoted(String text) {
    return '"' + text.replace('"', '\'').replace('\n', ' ') + '"';
  }

  private static String unquoted(String text) {
    return text.substring(1, text.length() - 1);
  }

  private static Map<String, Long> limits(String text) {
    Map<String, Long> limits = new LinkedHashMap<>();
    for (String limit : text.isEmpty() ? new String[0] : text.split("; ", -1)) {
      int colon = limit.lastIndexOf(": ");
      limits.put(limit.substring(0, colon), Long.parseLong(limit.substring(colon + 2)));
    }
    return limits;
  }

  private static String shortened(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.4e", value) : "" + value;
  }

  /**
   * Reads a line that {@link #line} wrote.
   *
   * @throws IllegalArgumentException if it is not such a line
   */
  public static MeasuredRun parse(String line) {
    List<String> parts = List.of(line.split(",(?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", -1));
    if (parts.size() != FIELDS) {
      throw new IllegalArgumentException("a run has " + FIELDS + " fields: " + line);
    }
    return new MeasuredRun(
        parts.get(0),
        Double.parseDouble(parts.get(1)),
        Integer.parseInt(parts.get(2)),
        unquoted(parts.get(3)),
        Double.parseDouble(parts.get(4)),
        Long.parseLong(parts.get(5)),
        Long.parseLong(parts.get(6)),
        Long.parseLong(parts.get(7)),
        Long.parseLong(parts.get(8)),
        Long.parseLong(parts.get(9)),
        Long.parseLong(parts.get(10)),
        new Errors(
            number(parts, 11),
            number(parts, 12),
            number(parts, 13),
            number(parts, 14),
            number(parts, 15),
            number(parts, 16)),
        number(parts, 17),
        limits(unquoted(parts.get(18))));
  }

  private static double number(List<String> parts, int index) {
    return Double.parseDouble(parts.get(index));
  }
}
