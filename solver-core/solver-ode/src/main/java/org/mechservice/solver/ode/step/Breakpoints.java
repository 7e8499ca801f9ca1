package org.mechservice.solver.ode.step;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.ode.PiecewiseSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SystemParts;

/** The places at which the equations jump, in the direction of integration. */
public final class Breakpoints {
  private static final double[] NONE = {Double.POSITIVE_INFINITY};

  /**
   * Relative distance of a place within which the equations are not evaluated: where they jump is
   * known to rounding.
   */
  private static final double MARGIN = 4 * Math.ulp(1.0);

  /** Relative distance within which places are one, from the first to the last of them. */
  private static final double ONE = 1024 * Math.ulp(1.0);

  /** Places times the direction, ascending, the last one infinite. */
  private double[] ahead = NONE;

  /** Of each place, the last of those that are one with it. */
  private double[] until = NONE;

  private double direction = 1;
  private int next;

  /** The piece in which the equations are evaluated, in the direction of integration. */
  private double first = Double.NEGATIVE_INFINITY;

  private double last = Double.POSITIVE_INFINITY;

  /**
   * Begins a problem.
   *
   * @param system the problem, asked for its {@link PiecewiseSystem} part
   * @throws IllegalArgumentException if a place is not a number
   */
  public void begin(SystemParts system, double t0, double tEnd) {
    direction = tEnd < t0 ? -1 : 1;
    List<Double> places =
        system.part(PiecewiseSystem.class).map(PiecewiseSystem::breakpoints).orElse(List.of());
    setPlaces(direction * t0, places);
    next = 0;
    first = Double.NEGATIVE_INFINITY;
    last = before(ahead[0]);
    if (reachedAt(t0)) {
      pass();
    }
  }

  private void setPlaces(double start, List<Double> places) {
    double[] ascending =
        places.stream()
            .mapToDouble(place -> direction * requireNumber(place))
            .filter(place -> place >= start)
            .sorted()
            .toArray();
    double[] from = new double[ascending.length + 1];
    double[] to = new double[from.length];
    int count = 0;
    for (double place : ascending) {
      if (count > 0 && place - from[count - 1] <= ONE * Math.abs(place)) {
        to[count - 1] = place;
      } else {
        from[count] = place;
        to[count++] = place;
      }
    }
    from[count] = Double.POSITIVE_INFINITY;
    to[count] = Double.POSITIVE_INFINITY;
    ahead = Arrays.copyOf(from, count + 1);
    until = Arrays.copyOf(to, count + 1);
  }

  private static double requireNumber(double place) {
    if (Double.isNaN(place)) {
      throw new IllegalArgumentException("a breakpoint is NaN; it must be a number");
    }
    return place;
  }

  private static double before(double place) {
    return Double.isInfinite(place) ? place : Math.nextDown(place - MARGIN * Math.abs(place));
  }

  private static double behind(double place) {
    return Math.nextUp(place + MARGIN * Math.abs(place));
  }

  /** Returns which way time runs: 1 or -1. */
  public double direction() {
    return direction;
  }

  /** Returns the next place; infinite, in the direction of integration, if there is none. */
  public double next() {
    return direction * ahead[next];
  }

  /** Returns whether {@code t} is the next place. */
  public boolean reachedAt(double t) {
    return direction * t >= ahead[next];
  }

  /** Goes on beyond the next place. */
  public void pass() {
    first = behind(until[next]);
    next++;
    last = before(ahead[next]);
  }

  /** Goes on beyond all places up to {@code t}. */
  public void passUpTo(double t) {
    while (reachedAt(t)) {
      pass();
    }
  }

  /** Returns where to evaluate instead of at {@code t}, so as to stay between two places. */
  public double inside(double t) {
    return direction * Math.max(first, Math.min(last, direction * t));
  }

  /** Carries over how many places were passed. */
  public void transfer(SavedState state) {
    int passed = state.integer(next);
    if (passed < 0 || passed >= ahead.length) {
      throw new IllegalArgumentException("the saved state has passed other breakpoints");
    }
    next = passed;
    first = passed == 0 ? Double.NEGATIVE_INFINITY : behind(until[passed - 1]);
    last = before(ahead[passed]);
  }
}
