package org.mechservice.solver.ode.step;

import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import java.util.stream.DoubleStream;
import org.mechservice.solver.ode.PiecewiseSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SystemParts;

/** The places at which the equations jump, in the direction of integration. */
public final class Breakpoints {
  /**
   * Relative distance of a place within which the equations are not evaluated: where they jump is
   * known to rounding.
   */
  private static final double MARGIN = 4 * Math.ulp(1.0);

  /** Relative distance within which places are one, from the first to the last of them. */
  private static final double ONE = 1024 * Math.ulp(1.0);

  /** Listed places times the direction, ascending, the last one infinite. */
  private double[] listed = {Double.POSITIVE_INFINITY};

  /** Places that are not listed, in the direction of integration. */
  private LongToDoubleFunction sequence = index -> Double.NaN;

  private double direction = 1;

  /** How many places lie behind, of the list and of the sequence. */
  private int passedOfList;

  private long passedOfSequence;

  /** The next place times the direction, and the last of those that are one with it. */
  private double ahead = Double.POSITIVE_INFINITY;

  private double until = Double.POSITIVE_INFINITY;

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
    double start = direction * t0;
    Optional<PiecewiseSystem> pieces = system.part(PiecewiseSystem.class);
    List<Double> places = pieces.map(PiecewiseSystem::breakpoints).orElse(List.of());
    DoubleStream ascending =
        places.stream()
            .mapToDouble(place -> direction * requireNumber(place))
            .filter(place -> place >= start)
            .sorted();
    listed = DoubleStream.concat(ascending, DoubleStream.of(Double.POSITIVE_INFINITY)).toArray();
    sequence = pieces.map(PiecewiseSystem::sequence).orElse(index -> Double.NaN);
    passedOfList = 0;
    passedOfSequence = 0;
    while (ofSequence() < start) {
      passedOfSequence++;
    }
    first = Double.NEGATIVE_INFINITY;
    findNext();
    if (reachedAt(t0)) {
      pass();
    }
  }

  private double ofSequence() {
    double place = direction * sequence.applyAsDouble(passedOfSequence);
    return Double.isNaN(place) ? Double.POSITIVE_INFINITY : place;
  }

  /** Finds the next place and those that are one with it. */
  private void findNext() {
    ahead = takeNearest();
    until = ahead;
    while (nearest() - ahead <= ONE * Math.abs(ahead) && !Double.isInfinite(nearest())) {
      until = takeNearest();
    }
    last = before(ahead);
  }

  private double nearest() {
    return Math.min(listed[passedOfList], ofSequence());
  }

  private double takeNearest() {
    double place = nearest();
    if (Double.isInfinite(place)) {
      return place;
    }
    if (place == listed[passedOfList]) {
      passedOfList++;
    } else {
      passedOfSequence++;
    }
    return place;
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
    return direction * ahead;
  }

  /** Returns whether {@code t} is the next place. */
  public boolean reachedAt(double t) {
    return direction * t >= ahead;
  }

  /** Goes on beyond the next place. */
  public void pass() {
    first = behind(until);
    findNext();
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

  /** Carries over which places were passed. */
  public void transfer(SavedState state) {
    passedOfList = state.integer(passedOfList);
    passedOfSequence = state.integer(passedOfSequence);
    if (passedOfList < 0 || passedOfList >= listed.length || passedOfSequence < 0) {
      throw new IllegalArgumentException("the saved state has passed other breakpoints");
    }
    ahead = state.number(ahead);
    until = state.number(until);
    first = state.number(first);
    last = state.number(last);
  }
}
