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
 * @param cause why the end was not reached; empty if it was
 */
record SuiteRun(
    String problem,
    String solver,
    double tolerance,
    double error,
    long evaluations,
    long steps,
    String cause) {
  /** Returns the digits at the end; 0 at least. */
  double digits() {
    return Double.isNaN(error) ? Double.NaN : Math.max(0, -Math.log10(Math.max(error, 1e-17)));
  }
}
