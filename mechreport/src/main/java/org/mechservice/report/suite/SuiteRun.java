package org.mechservice.report.suite;

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
  /** Returns the same run with another time. */
  SuiteRun taking(double median) {
    return new SuiteRun(problem, solver, tolerance, error, evaluations, steps, median, cause);
  }

  /** Returns the digits at the end; 0 at least. */
  double digits() {
    return Double.isNaN(error) ? Double.NaN : Math.max(0, -Math.log10(Math.max(error, 1e-17)));
  }
}
