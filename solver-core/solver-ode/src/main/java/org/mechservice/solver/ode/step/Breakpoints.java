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
   * Relative distance of a place within which the equations are not evaluated, and within which two
   * places are one: where they jump is known to rounding.
   */
  private static final double MARGIN = 4 * Math.ulp(1.0);

  /** Places times the direction, ascending, the last one infinite. */
  private double[] ahead = NONE;

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
    ahead = places.isEmpty() ? NONE : aheadOf(direction * t0, places);
    next = 0;
    first = Double.NEGATIVE_INFINITY;
    last = before(ahead[0]);
    if (reachedAt(t0)) {
      pass();
    }
  }

  private double[] aheadOf(double start, List<Double> places) {
    double[] ascending =
        places.stream()
            .mapToDouble(place -> direction * requireNumber(place))
            .filter(place -> place >= start)
            .sorted()
            .toArray();
    double[] ahead = new double[ascending.length + 1];
    int count = 0;
    for (double place : ascending) {
      if (count == 0 || place > behind(ahead[count - 1])) {
        ahead[count++] = place;
      }
    }
    ahead[count] = Double.POSITIVE_INFINITY;
    return Arrays.copyOf(ahead, count + 1);
  }

  private static double before(double place) {
    return Double.isInfinite(place) ? place : Math.nextDown(place - MARGIN * Math.abs(place));
  }

  private static double behind(double place) {
    return Math.nextUp(place + MARGIN * Math.abs(place));
  }

  private static double requireNumber(double place) {
    if (Double.isNaN(place)) {
      throw new IllegalArgumentException("a breakpoint is NaN; it must be a number");
    }
    return place;
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
    first = behind(ahead[next]);
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
    first = passed == 0 ? Double.NEGATIVE_INFINITY : behind(ahead[passed - 1]);
    last = before(ahead[passed]);
  }
}
