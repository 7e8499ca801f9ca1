package org.mechservice.solver.ode.events;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;

/**
 * Surveys a step before its events are looked for: it evaluates the functions at the points of the
 * search and, where one comes near zero and turns back between them, looks for its extremum. A
 * function that crosses zero there and returns gets a further point of the search behind its first
 * crossing; one that only touches zero is reported and has no event.
 *
 * <p>An extremum is looked for only where it may reach zero: the value beside it is no more than a
 * few times the sag of the function below its chord. It is found by successive parabolas with the
 * golden section as a fallback (Brent, <i>Algorithms for Minimization without Derivatives</i>,
 * 1973, chapter 5).
 */
final class TurnSearch {
  /**
   * How far an extremum may lie below the lowest point known, in sags below the chord times the
   * ratio of the longer part of the bracket to the shorter one. For a parabola it is 1/4, for a
   * kink up to 1.
   */
  private static final double REACH = 2;

  /** Part of the first and of the last stretch of a step by which to see where a function goes. */
  private static final double SLIGHTLY = 1e-5;

  private static final double GOLDEN = 0.5 * (3 - Math.sqrt(5));

  /** Most places looked at for an extremum: twice those of the golden section to round-off. */
  private static final int MOST_LOOKS = 160;

  private final EventSigns signs;
  private final EventFunctions functions;
  private final EventSearch.Path path;

  /** Whether a function came nearer to zero at the end of the step before. */
  private final boolean[] approaching;

  /** End of the step before. */
  private double lastEnd = Double.NaN;

  /** The beginning of the step and the points of the search, with the values at them. */
  private double[] base = {};

  private double[][] values = {};

  /** Number of these, and of those with values. */
  private int count;

  private int evaluated;

  /** Points of the search in the order of integration, those behind found crossings included. */
  private double[] points = {};

  private int pointCount;

  private final double[] look;

  /** Bracket of an extremum: its ends and the lowest place between, with distances from zero. */
  private double tLow;

  private double tMin;
  private double tHigh;
  private double gLow;
  private double gMin;
  private double gHigh;

  TurnSearch(EventSigns signs, EventFunctions functions, EventSearch.Path path) {
    this.signs = signs;
    this.functions = functions;
    this.path = path;
    approaching = new boolean[functions.count()];
    look = new double[functions.count()];
  }

  /**
   * Surveys a step.
   *
   * @param begin where it begins
   * @param end where it ends
   * @param parts points of the search, ascending parts of the step up to 1; not modified
   * @param atBegin values at its beginning; not modified
   */
  void survey(double begin, double end, double[] parts, double[] atBegin) {
    reserve(parts.length);
    base[0] = begin;
    System.arraycopy(atBegin, 0, values[0], 0, atBegin.length);
    count = 1;
    evaluated = 1;
    pointCount = 0;
    for (double part : parts) {
      double t = part == 1 ? end : begin + part * (end - begin);
      base[count] = t;
      points[pointCount++] = t;
      evaluated += evaluated == count && path.evaluate(t, values[count]) ? 1 : 0;
      count++;
    }
    if (begin != lastEnd || evaluated < count) {
      Arrays.fill(approaching, false);
    }
    lastEnd = end;
    for (int i = 0; i < look.length && evaluated == count; i++) {
      lookForTurns(i);
    }
  }

  private void reserve(int parts) {
    if (base.length <= parts) {
      base = new double[parts + 1];
      values = new double[parts + 1][look.length];
      points = new double[parts + look.length];
    }
  }

  /** Returns the number of points of the search. */
  int pointCount() {
    return pointCount;
  }

  /** Returns a point of the search, from 0 on. */
  double point(int index) {
    return points[index];
  }

  /** Copies the values at a place if they are known, and returns whether they are. */
  boolean known(double t, double[] g) {
    for (int k = 1; k < evaluated; k++) {
      if (base[k] == t) {
        System.arraycopy(values[k], 0, g, 0, g.length);
        return true;
      }
    }
    return false;
  }

  private void lookForTurns(int i) {
    for (int k = 1; k + 1 < count; k++) {
      double side = Math.signum(values[k - 1][i]);
      boolean between = side * values[k + 1][i] > 0 && signs.awaitsEvent(i, values[k - 1][i]);
      if (between && values[k][i] == 0) {
        // The smallest value on this side says that there is no change of sign.
        values[k][i] = side * Double.MIN_VALUE;
        functions.noEvent(i, NoEvent.TOUCH, base[k], 0);
      } else if (between && nearest(i, side, k - 1, k, k + 1)) {
        bracket(k - 1, base[k], side * values[k][i], k + 1, i, side);
        refine(i, side);
      }
    }
    lookAtBeginning(i);
    lookAtEnd(i);
  }

  /** Returns whether a function is nearer to zero at a point than at those beside it. */
  private boolean nearest(int i, double side, int before, int k, int behind) {
    double g = side * values[k][i];
    double from = side * values[before][i];
    double to = side * values[behind][i];
    return g > 0 && g <= from && g <= to && (g < from || g < to);
  }

  /** Looks for an extremum in the first stretch, towards which the step before has led. */
  private void lookAtBeginning(int i) {
    double side = Math.signum(values[0][i]);
    double g = side * values[0][i];
    double next = side * values[1][i];
    if (!approaching[i] || !(next > g) || !mayReachZero(i, g, sag(i, 1))) {
      return;
    }
    double t = base[0] + SLIGHTLY * (base[1] - base[0]);
    if (path.evaluate(t, look) && side * look[i] < g) {
      bracket(0, t, side * look[i], 1, i, side);
      refineOrCross(i, side);
    } else if (g <= signs.touchWidth(i)) {
      functions.noEvent(i, NoEvent.TOUCH, base[0], values[0][i]);
    }
  }

  /** Looks for an extremum in the last stretch. */
  private void lookAtEnd(int i) {
    int end = count - 1;
    double side = Math.signum(values[end][i]);
    double g = side * values[end][i];
    double last = side * values[end - 1][i];
    approaching[i] = last > g && g > 0 && signs.awaitsEvent(i, values[end - 1][i]);
    if (!approaching[i] || !mayReachZero(i, g, sag(i, end - 1))) {
      return;
    }
    double t = base[end] - SLIGHTLY * (base[end] - base[end - 1]);
    if (path.evaluate(t, look) && side * look[i] < g) {
      approaching[i] = false;
      bracket(end - 1, t, side * look[i], end, i, side);
      refineOrCross(i, side);
    }
  }

  /** Returns how far a function is off the chord at a point between its neighbours. */
  private double sag(int i, int k) {
    if (k < 1 || k + 1 >= count) {
      return Double.POSITIVE_INFINITY;
    }
    double part = (base[k] - base[k - 1]) / (base[k + 1] - base[k - 1]);
    double chord = values[k - 1][i] + part * (values[k + 1][i] - values[k - 1][i]);
    return Math.abs(chord - values[k][i]);
  }

  private boolean mayReachZero(int i, double g, double sag) {
    return g <= REACH * sag + signs.touchWidth(i);
  }

  private void bracket(int low, double t, double g, int high, int i, double side) {
    tLow = base[low];
    gLow = side * values[low][i];
    tMin = t;
    gMin = g;
    tHigh = base[high];
    gHigh = side * values[high][i];
  }

  private void refineOrCross(int i, double side) {
    if (gMin < 0) {
      insert(tMin);
    } else {
      refine(i, side);
    }
  }

  /**
   * Narrows the bracket down to the extremum, as long as that may reach zero. A place beyond zero
   * becomes a point of the search, and an extremum at zero is told.
   */
  private void refine(int i, double side) {
    boolean halved = true;
    for (int looks = 0; looks < MOST_LOOKS; looks++) {
      double part = (tMin - tLow) / (tHigh - tLow);
      double sag = gLow + part * (gHigh - gLow) - gMin;
      double skew = Math.max(part, 1 - part) / Math.min(part, 1 - part);
      if (!mayReachZero(i, gMin, skew * sag)) {
        return;
      }
      double length = Math.abs(tHigh - tLow);
      double width = EventSearch.width(tMin, base[count - 1] - base[0]);
      double t = halved ? vertex(width) : goldenSection();
      if (length <= 2 * width || sag <= signs.roundOff(i) || !path.evaluate(t, look)) {
        break;
      }
      double g = side * look[i];
      if (g < 0) {
        insert(t);
        return;
      }
      narrow(t, g);
      halved = Math.abs(tHigh - tLow) <= 0.5 * length;
    }
    if (gMin <= signs.touchWidth(i)) {
      functions.noEvent(i, NoEvent.TOUCH, tMin, side * gMin);
    }
  }

  /** Returns the lowest place of the parabola through the bracket, a little off known places. */
  private double vertex(double width) {
    double slopeLow = (gMin - gLow) / (tMin - tLow);
    double slopeHigh = (gHigh - gMin) / (tHigh - tMin);
    double curvature = (slopeHigh - slopeLow) / (tHigh - tLow);
    double middle = 0.5 * (tLow + tMin);
    double t = middle - 0.5 * slopeLow / curvature;
    double forward = Math.signum(tHigh - tLow);
    boolean inside = (t - tLow) * forward > width && (tHigh - t) * forward > width;
    if (!inside) {
      return goldenSection();
    }
    if (Math.abs(t - tMin) >= width) {
      return t;
    }
    boolean longerBehind = Math.abs(tHigh - tMin) > Math.abs(tMin - tLow);
    return tMin + (longerBehind ? forward : -forward) * width;
  }

  /** Returns the place at the golden section of the longer part of the bracket. */
  private double goldenSection() {
    double behind = tHigh - tMin;
    double before = tLow - tMin;
    return tMin + GOLDEN * (Math.abs(behind) > Math.abs(before) ? behind : before);
  }

  private void narrow(double t, double g) {
    boolean behind = (t - tMin) * (tHigh - tLow) > 0;
    if (g <= gMin) {
      if (behind) {
        tLow = tMin;
        gLow = gMin;
      } else {
        tHigh = tMin;
        gHigh = gMin;
      }
      tMin = t;
      gMin = g;
    } else if (behind) {
      tHigh = t;
      gHigh = g;
    } else {
      tLow = t;
      gLow = g;
    }
  }

  /** Adds a point of the search. */
  private void insert(double t) {
    if (pointCount == points.length) {
      points = Arrays.copyOf(points, 2 * pointCount);
    }
    double forward = base[count - 1] - base[0];
    int k = pointCount++;
    while (k > 0 && (points[k - 1] - t) * forward > 0) {
      points[k] = points[k - 1];
      k--;
    }
    points[k] = t;
  }

  /** Carries over what is known of the step before. */
  void transfer(SavedState state) {
    lastEnd = state.number(lastEnd);
    for (int i = 0; i < approaching.length; i++) {
      approaching[i] = state.flag(approaching[i]);
    }
  }
}
