package org.mechservice.report.reference;

import java.util.Optional;

/** A code of high order that solves a problem at given times. */
public interface ReferenceCode {
  /** Returns the code's name with its order, for the page. */
  String name();

  /**
   * Solves a problem.
   *
   * @param times increasing; the first is the start
   * @param y0 state at the start; not modified
   * @param tolerance of the local error relative to 1 + |y|, in the code's own measure
   * @param deadline {@link System#nanoTime()} after which it gives up
   * @return one state per time, fewer if the {@linkplain Problem#phases problem} ends its solution
   *     before; empty if the code fails or does not end in time
   */
  Optional<double[][]> solve(
      Problem problem, double[] times, double[] y0, double tolerance, long deadline);
}
