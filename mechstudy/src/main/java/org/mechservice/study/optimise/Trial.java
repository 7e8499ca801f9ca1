package org.mechservice.study.optimise;

import java.util.Optional;

/**
 * One point that an optimiser has tried.
 *
 * @param start number of the start it belongs to, from 1
 * @param run number of the run of that start, from 1
 * @param point values of the variables
 * @param values values of the aims; NaN for all if the point failed
 * @param objective what is minimised: the objective, or the sum of the residuals' squares; the
 *     value given for failing points if it failed
 * @param violation largest violation of a constraint, scaled; 0 if all hold
 * @param failure why the point failed; empty if it did not
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Trial(
    int start,
    int run,
    double[] point,
    double[] values,
    double objective,
    double violation,
    Optional<String> failure) {
  /** Scaled violation of a constraint that counts as none. */
  static final double FEASIBLE = 1e-6;

  /** Returns whether the point was computed and all constraints hold there. */
  public boolean isFeasible() {
    return failure.isEmpty() && violation <= FEASIBLE;
  }

  /** Returns whether this point is a better answer than another. */
  boolean isBetterThan(Trial other) {
    if (failure.isPresent() != other.failure.isPresent()) {
      return failure.isEmpty();
    } else if (isFeasible() != other.isFeasible()) {
      return isFeasible();
    }
    return isFeasible() ? objective < other.objective : violation < other.violation;
  }
}
