package org.mechservice.report.measure;

import java.util.List;
import java.util.Locale;

/**
 * One run of one method at one tolerance.
 *
 * @param method name of the method
 * @param tolerance relative tolerance asked for; the absolute one is a hundredth of it, SI
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
    double energyDrift) {

  /** Header of the file that {@link #line} writes lines of. */
  public static final String HEADER =
      "method,relative_tolerance,round,cause,seconds,bytes_allocated,steps,rejected_steps,"
          + "evaluations,jacobians,factorisations,error_at_end,largest_error,position_error,"
          + "velocity_error,energy_drift";

  private static final int FIELDS = 16;

  /**
   * Distances from the reference, in the sense of {@link StateDistance}; NaN if the run did not
   * reach the end.
   *
   * @param atEnd at the end
   * @param largest over time
   * @param ofPositions largest over time, positions alone
   * @param ofVelocities largest over time, velocities alone
   */
  public record Errors(double atEnd, double largest, double ofPositions, double ofVelocities) {
    /** Of a run that did not reach the end. */
    public static final Errors NONE = new Errors(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
  }

  /** Returns whether the run reached the end. */
  public boolean completed() {
    return cause.isEmpty();
  }

  /** Returns the same run where nobody knows its errors. */
  public MeasuredRun withoutErrors() {
    return new MeasuredRun(
        method,
        tolerance,
        round,
        cause,
        seconds,
        bytes,
        steps,
        rejected,
        evaluations,
        jacobians,
        factorisations,
        Errors.NONE,
        energyDrift);
  }

  /** Returns the run as a line of a CSV file. */
  public String line() {
    return String.join(
        ",",
        method,
        Double.toString(tolerance),
        Integer.toString(round),
        '"' + cause.replace('"', '\'').replace('\n', ' ') + '"',
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
        shortened(energyDrift));
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
    String cause = parts.get(3);
    return new MeasuredRun(
        parts.get(0),
        Double.parseDouble(parts.get(1)),
        Integer.parseInt(parts.get(2)),
        cause.substring(1, cause.length() - 1),
        Double.parseDouble(parts.get(4)),
        Long.parseLong(parts.get(5)),
        Long.parseLong(parts.get(6)),
        Long.parseLong(parts.get(7)),
        Long.parseLong(parts.get(8)),
        Long.parseLong(parts.get(9)),
        Long.parseLong(parts.get(10)),
        new Errors(number(parts, 11), number(parts, 12), number(parts, 13), number(parts, 14)),
        number(parts, 15));
  }

  private static double number(List<String> parts, int index) {
    return Double.parseDouble(parts.get(index));
  }
}
