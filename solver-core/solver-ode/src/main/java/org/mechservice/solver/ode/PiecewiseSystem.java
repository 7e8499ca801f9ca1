package org.mechservice.solver.ode;

import java.util.List;
import java.util.function.LongToDoubleFunction;

/**
 * A problem whose equations jump at known places. Implemented beside {@link OdeSystem} or {@link
 * ResidualSystem}.
 *
 * <p>A step ends exactly at each place, and the next one begins there anew at order 1. The
 * equations are never evaluated at the place itself but one rounding unit before it for the steps
 * that lead there and one after it for those that follow, so that it does not matter which of the
 * two values they have at the jump.
 */
public interface PiecewiseSystem {
  /** Returns the places, in any order; those outside of the interval are left alone. */
  List<Double> breakpoints();

  /**
   * Returns further places as a sequence that is never listed as a whole: the place of each index
   * from 0, ascending in the direction of integration and farther apart than rounding, NaN behind
   * the last one.
   */
  default LongToDoubleFunction sequence() {
    return index -> Double.NaN;
  }
}
