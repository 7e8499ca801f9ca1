package org.mechservice.benchmarks.suite;

import java.util.Locale;

/**
 * One integrator on one problem at one tolerance.
 *
 * @param problem its id
 * @param solver the integrator's name
 * @param tolerance relative
 * @param error at the end; NaN if it was not reached
 * @param evaluations of the right-hand side or residual, those for Jacobians included
 * @param steps accepted
 * @param seconds of the run, warm, s; NaN where the equations are evaluated in another language
 * @param cause why the end was not reached; empty if it was
 */
record SuiteRun(
    String problem,
    String solver,
    double tolerance,
    double error,
    long evaluations,
    long steps,
    double seconds,
    String cause) {
  /** Header of the file that {@link #line} writes lines of. */
  static final String HEADER =
      "problem,solver,relative_tolerance,error_at_end,evaluations,steps,seconds,cause";

  /** Returns the run as a line of a CSV file. */
  String line() {
    return String.format(
        Locale.ROOT,
        "%s,%s,%.0e,%.4e,%d,%d,%.6e,\"%s\"",
        problem,
        solver,
        tolerance,
        error,
        evaluations,
        steps,
        seconds,
        cause.replace('"', '\''));
  }

  /** Returns the same run with another time. */
  SuiteRun taking(double median) {
    return new SuiteRun(problem, solver, tolerance, error, evaluations, steps, median, cause);
  }

  /** Returns the digits at the end; 0 at least. */
  double digits() {
    return Double.isNaN(error) ? Double.NaN : Math.max(0, -Math.log10(Math.max(error, 1e-17)));
  }
}
