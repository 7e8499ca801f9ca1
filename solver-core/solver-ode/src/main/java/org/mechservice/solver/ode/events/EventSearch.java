package org.mechservice.solver.ode.events;

import java.util.Arrays;

/**
 * Finds the first event in an interval at whose end there is one, by the rule of false position in
 * the Illinois form: the end that stays counts half as much each time, and where that does not
 * halve the interval, bisection does.
 */
public final class EventSearch {
  /** Width of the interval that is left, relative to t and to the step. */
  private static final double ROUNDOFFS = 100 * Math.ulp(1.0);

  private static final double OF_STEP = 1e-12;

  /** Part of an interval at which to look if a function has no value at the place wanted. */
  private static final double BESIDE = 0.3;

  /** Distances from a change of sign, in units of its width, at which a pole shows itself. */
  private static final double NEAR = 8;

  private static final double FAR = 64;

  /**
   * Least growth between these distances: a pole of 1 / t^(1/5) grows by 1.5, while a jump or a
   * continuous function that passes zero stays or becomes smaller.
   */
  private static final double POLE_GROWTH = 1.5;

  /** The event functions along the solution. */
  interface Path {
    /** Evaluates the functions; returns false if that is not possible there. */
    boolean evaluate(double t, double[] g);
  }

  private final EventSigns signs;
  private double[] before;
  private double[] behind;
  private double[] middle;
  private final double[] near;
  private double tBefore;
  private double tBehind;

  /** Weights of the two ends. */
  private double weightBefore;

  private double weightBehind;

  EventSearch(EventSigns signs, int count) {
    this.signs = signs;
    before = new double[count];
    behind = new double[count];
    middle = new double[count];
    near = new double[count];
  }

  /** Returns the width to which an event can be located. */
  public static double width(double t, double stepSize) {
    return Math.max(ROUNDOFFS * Math.abs(t), OF_STEP * Math.abs(stepSize));
  }

  /**
   * Narrows an interval down to its first event.
   *
   * @param tFrom where it begins, with values that are no events
   * @param gFrom not modified
   * @param tTo where it ends, with values of which at least one is
   * @param gTo not modified
   * @param width of the interval left
   * @return false if the functions cannot be evaluated somewhere between
   */
  boolean locate(double tFrom, double[] gFrom, double tTo, double[] gTo, double width, Path path) {
    tBefore = tFrom;
    tBehind = tTo;
    System.arraycopy(gFrom, 0, before, 0, before.length);
    System.arraycopy(gTo, 0, behind, 0, behind.length);
    weightBefore = 1;
    weightBehind = 1;
    int slow = 0;
    while (Math.abs(tBehind - tBefore) > width) {
      double last = Math.abs(tBehind - tBefore);
      double t = slow < 2 ? proposal(width) : 0.5 * (tBefore + tBehind);
      if (t == tBefore || t == tBehind) {
        return true;
      }
      if (!path.evaluate(t, middle)) {
        // At a pole a single place has no value.
        t = tBefore + BESIDE * (tBehind - tBefore);
        if (!path.evaluate(t, middle)) {
          return false;
        }
      }
      narrow(t);
      slow = Math.abs(tBehind - tBefore) > 0.5 * last ? slow + 1 : 0;
    }
    return true;
  }

  /** The first zero of the straight lines between the ends, a little inside of them. */
  private double proposal(double width) {
    double first = 1;
    for (int i = 0; i < behind.length; i++) {
      if (signs.event(i, behind[i])) {
        double from = weightBefore * signs.distance(i, before[i]);
        double to = weightBehind * signs.distance(i, behind[i]);
        first = Math.min(first, from > 0 ? from / (from - to) : 0.5);
      }
    }
    double length = tBehind - tBefore;
    double margin = Math.min(0.5, 0.5 * width / Math.abs(length));
    return tBefore + length * Math.max(margin, Math.min(1 - margin, first));
  }

  private void narrow(double t) {
    double[] freed = middle;
    if (signs.anyEvent(middle)) {
      middle = behind;
      behind = freed;
      tBehind = t;
      weightBehind = 1;
      weightBefore *= 0.5;
    } else {
      middle = before;
      before = freed;
      tBefore = t;
      weightBefore = 1;
      weightBehind *= 0.5;
    }
  }

  /**
   * Finds the functions that have changed their sign through infinity at the place found: on both
   * sides of it they grow towards it.
   *
   * @param occurred functions that have changed their sign; not modified
   * @param tFrom where the interval searched began
   * @param tTo where it ended
   * @param width to which the place is located
   * @param atPole overwritten
   */
  void findPoles(
      boolean[] occurred, double tFrom, double tTo, double width, Path path, boolean[] atPole) {
    System.arraycopy(occurred, 0, atPole, 0, atPole.length);
    double unit = Math.copySign(width, tTo - tFrom);
    keepGrowing(tBehind, unit, tTo, behind, path, atPole);
    keepGrowing(tBefore, -unit, tFrom, before, path, atPole);
  }

  /** Leaves the functions that grow towards a place, seen from one side of it. */
  private void keepGrowing(
      double t, double unit, double end, double[] there, Path path, boolean[] growing) {
    boolean inside = (end - t) * unit >= FAR * unit * unit;
    if (!inside || !path.evaluate(t + NEAR * unit, middle)) {
      Arrays.fill(growing, false);
      return;
    }
    boolean any = false;
    for (int i = 0; i < growing.length; i++) {
      near[i] = Math.abs(middle[i]);
      growing[i] &= Math.abs(there[i]) > near[i];
      any |= growing[i];
    }
    if (any && path.evaluate(t + FAR * unit, middle)) {
      for (int i = 0; i < growing.length; i++) {
        growing[i] &= near[i] > POLE_GROWTH * Math.abs(middle[i]);
      }
    }
  }

  /** Returns where the event has happened. */
  double time() {
    return tBehind;
  }

  /** Returns the values just before the event; not to be modified. */
  double[] before() {
    return before;
  }

  /** Returns the values where the event has happened; not to be modified. */
  double[] behind() {
    return behind;
  }
}
