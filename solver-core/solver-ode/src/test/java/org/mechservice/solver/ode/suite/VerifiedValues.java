package org.mechservice.solver.ode.suite;

/**
 * Frame and verified values of a problem that starts at t = 0.
 *
 * @param end where it ends
 * @param initialState state at t = 0; not modified
 * @param scale size of each component: its absolute tolerance is the relative one times this
 * @param atEnd state at the end
 * @param checkpointTime a point inside the interval
 * @param atCheckpoint state there
 */
@SuppressWarnings("ArrayRecordComponent") // compared by nobody
public record VerifiedValues(
    double end,
    double[] initialState,
    double[] scale,
    double[] atEnd,
    double checkpointTime,
    double[] atCheckpoint) {

  /** Returns −log10 of the largest error, each relative to size plus scale of its component. */
  public double mixedDigits(double[] y, double[] reference) {
    double worst = 0;
    for (int i = 0; i < y.length; i++) {
      worst = Math.max(worst, Math.abs(y[i] - reference[i]) / (Math.abs(reference[i]) + scale[i]));
    }
    return -StrictMath.log10(worst);
  }
}
