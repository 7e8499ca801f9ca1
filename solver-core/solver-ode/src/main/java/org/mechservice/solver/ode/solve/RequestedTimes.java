package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.SavedState;

/**
 * Times at which the solution is asked for, in the direction of integration, and the receivers of
 * the solution.
 */
final class RequestedTimes {
  /** Part of a distance by which the last of equal distances may miss the end. */
  private static final double ROUNDING = 1e-9;

  private final Request request;
  private final double start;
  private final double end;
  private long next;

  private RequestedTimes(Request request, double start, double end) {
    this.request = request;
    this.start = start;
    this.end = end;
  }

  /**
   * One request.
   *
   * @param times in the direction of integration; empty: equal distances
   * @param distance positive, of equal distances
   */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  record Request(double[] times, double distance, OdeOptions.OutputHandler handler) {}

  /**
   * @throws IllegalArgumentException if the times are not in order or lie outside of the interval
   */
  static RequestedTimes of(Request request, double t0, double t1) {
    double direction = t1 < t0 ? -1 : 1;
    double[] times = request.times();
    for (int i = 0; i < times.length; i++) {
      boolean inside = direction * (times[i] - t0) >= 0 && direction * (t1 - times[i]) >= 0;
      if (!inside) {
        throw new IllegalArgumentException(
            "output time "
                + i
                + " is "
                + times[i]
                + "; it must lie between the start "
                + t0
                + " and the end "
                + t1);
      }
      if (i > 0 && direction * (times[i] - times[i - 1]) < 0) {
        throw new IllegalArgumentException(
            "output time "
                + i
                + " is "
                + times[i]
                + " and comes after "
                + times[i - 1]
                + "; output times must be given in the order of integration");
      }
    }
    return new RequestedTimes(request, t0, t1);
  }

  /** Returns whether there is another time. */
  boolean hasNext() {
    if (request.times().length > 0) {
      return next < request.times().length;
    }
    double distance = request.distance();
    return distance > 0 && next * distance <= Math.abs(end - start) + ROUNDING * distance;
  }

  /** Returns the next time. */
  double next() {
    if (request.times().length > 0) {
      return request.times()[(int) next];
    }
    double distance = next * request.distance();
    boolean atEnd = distance >= Math.abs(end - start) - ROUNDING * request.distance();
    return atEnd ? end : start + Math.copySign(distance, end - start);
  }

  /** Passes the solution at the next time to its receiver. */
  void pass(double[] y) {
    double t = next();
    next++;
    request.handler().accept(t, y);
  }

  /** Carries over how many times were told. */
  void transfer(SavedState state) {
    next = state.integer(next);
  }
}
