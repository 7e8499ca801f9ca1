package org.mechservice.solver.expression;

import java.util.Arrays;
import org.mechservice.solver.expression.Table.Extrapolation;
import org.mechservice.solver.expression.Table.Method;
import org.mechservice.solver.spatial.NumberTable;
import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.GivenFunction;
import org.mechservice.solver.symbol.WatchedStep;

/**
 * The curve of a table: one polynomial c0 + d (c1 + d (c2 + d c3)) with d = x − origin for each
 * interval between points, and one for each side beyond them. Immutable.
 */
public final class TableCurve implements WatchedStep, GivenFunction {
  /** Numbers of a polynomial: origin, c0, c1, c2, c3. */
  private static final int NUMBERS = 5;

  /** Height of what is not there; its square is infinite. */
  private static final double BEYOND = 1e300;

  private final double[] knots;
  private final double[] polynomials;
  private final boolean bounded;
  private final boolean straight;
  private final boolean holds;

  TableCurve(Table table) {
    knots = table.x().stream().mapToDouble(Double::doubleValue).toArray();
    double[] y = table.y().stream().mapToDouble(Double::doubleValue).toArray();
    polynomials = new double[NUMBERS * (knots.length + 1)];
    double[] slope =
        table.slopes().isEmpty()
            ? slopes(table.method(), knots, y)
            : table.slopes().stream().mapToDouble(Double::doubleValue).toArray();
    int n = knots.length;
    for (int i = 0; i + 1 < n; i++) {
      double h = knots[i + 1] - knots[i];
      double chord = (y[i + 1] - y[i]) / h;
      if (table.method() == Method.LINEAR) {
        put(i + 1, knots[i], y[i], chord, 0, 0);
      } else {
        double c2 = (3 * chord - 2 * slope[i] - slope[i + 1]) / h;
        double c3 = (slope[i] + slope[i + 1] - 2 * chord) / (h * h);
        put(i + 1, knots[i], y[i], slope[i], c2, c3);
      }
    }
    holds = table.outside() == Extrapolation.HOLD;
    put(0, knots[0], y[0], holds ? 0 : slope[0], 0, 0);
    put(n, knots[n - 1], y[n - 1], holds ? 0 : slope[n - 1], 0, 0);
    bounded = table.outside() == Extrapolation.ERROR;
    straight = table.method() == Method.LINEAR;
  }

  private void put(int place, double origin, double c0, double c1, double c2, double c3) {
    int at = NUMBERS * place;
    polynomials[at] = origin;
    polynomials[at + 1] = c0;
    polynomials[at + 2] = c1;
    polynomials[at + 3] = c2;
    polynomials[at + 4] = c3;
  }

  /** Returns the slopes at the points; for straight lines those of the first and last interval. */
  static double[] slopes(Method method, double[] x, double[] y) {
    int n = x.length;
    double[] chord = chords(x, y);
    double[] slope = new double[n];
    if (n == 2 || method == Method.LINEAR) {
      slope[0] = chord[0];
      slope[n - 1] = chord[n - 2];
      return slope;
    }
    return switch (method) {
      case AKIMA -> akima(chord);
      case MONOTONE -> monotone(x, chord);
      default -> spline(x, chord);
    };
  }

  static double[] chords(double[] x, double[] y) {
    double[] chord = new double[x.length - 1];
    for (int i = 0; i < chord.length; i++) {
      chord[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    }
    return chord;
  }

  /**
   * Returns the slopes of chords with two more at each end, by Akima's parabola; equal ones if
   * there is one chord only. Chord i of the points is element i + 2.
   */
  static double[] extended(double[] chord) {
    int n = chord.length + 1;
    double[] m = new double[n + 3];
    if (n == 2) {
      Arrays.fill(m, chord[0]);
      return m;
    }
    System.arraycopy(chord, 0, m, 2, chord.length);
    m[1] = 2 * m[2] - m[3];
    m[0] = 2 * m[1] - m[2];
    m[n + 1] = 2 * m[n] - m[n - 1];
    m[n + 2] = 2 * m[n + 1] - m[n];
    return m;
  }

  /** Returns Akima's weight of the chord before point i; the one behind it has the rest. */
  static double weightBefore(double[] extended, int i) {
    double after = Math.abs(extended[i + 3] - extended[i + 2]);
    double before = Math.abs(extended[i + 1] - extended[i]);
    return after + before == 0 ? 0.5 : after / (after + before);
  }

  private static double[] akima(double[] chord) {
    double[] m = extended(chord);
    double[] slope = new double[chord.length + 1];
    for (int i = 0; i < slope.length; i++) {
      double after = Math.abs(m[i + 3] - m[i + 2]);
      double before = Math.abs(m[i + 1] - m[i]);
      slope[i] =
          after + before == 0
              ? (m[i + 1] + m[i + 2]) / 2
              : (after * m[i + 1] + before * m[i + 2]) / (after + before);
    }
    return slope;
  }

  /**
   * Returns Steffen's slopes: those of a parabola through three points where it is no steeper than
   * twice the flatter chord, and zero at an extremum of the points (M. Steffen, A simple method for
   * monotonic interpolation in one dimension, 1990, equations 8, 11 and 24 to 27).
   */
  private static double[] monotone(double[] x, double[] chord) {
    int n = x.length;
    double[] slope = new double[n];
    for (int i = 1; i + 1 < n; i++) {
      double before = x[i] - x[i - 1];
      double after = x[i + 1] - x[i];
      double parabola = (chord[i - 1] * after + chord[i] * before) / (before + after);
      double most = Math.min(Math.abs(chord[i - 1]), Math.abs(chord[i]));
      double sign = Math.signum(chord[i - 1]) + Math.signum(chord[i]);
      slope[i] = sign * Math.min(most, Math.abs(parabola) / 2);
    }
    slope[0] = endOfMonotone(x[1] - x[0], x[2] - x[1], chord[0], chord[1]);
    slope[n - 1] =
        endOfMonotone(x[n - 1] - x[n - 2], x[n - 2] - x[n - 3], chord[n - 2], chord[n - 3]);
    return slope;
  }

  private static double endOfMonotone(double own, double next, double chord, double nextChord) {
    double part = own / (own + next);
    double parabola = chord * (1 + part) - nextChord * part;
    if (parabola * chord <= 0) {
      return 0;
    }
    return Math.abs(parabola) > 2 * Math.abs(chord) ? 2 * chord : parabola;
  }

  /** Slopes of the spline: continuous curvature inside, one cubic over the two end intervals. */
  private static double[] spline(double[] x, double[] chord) {
    int n = x.length;
    if (n == 3) {
      double curve = (chord[1] - chord[0]) / (x[2] - x[0]);
      double h0 = x[1] - x[0];
      double h1 = x[2] - x[1];
      return new double[] {chord[0] - curve * h0, chord[0] + curve * h0, chord[1] + curve * h1};
    }
    double[] lower = new double[n];
    double[] middle = new double[n];
    double[] upper = new double[n];
    double[] right = new double[n];
    double h0 = x[1] - x[0];
    double h1 = x[2] - x[1];
    middle[0] = h1;
    upper[0] = h0 + h1;
    right[0] = ((h0 + 2 * (h0 + h1)) * h1 * chord[0] + h0 * h0 * chord[1]) / (h0 + h1);
    for (int i = 1; i + 1 < n; i++) {
      double before = x[i] - x[i - 1];
      double after = x[i + 1] - x[i];
      lower[i] = after;
      middle[i] = 2 * (before + after);
      upper[i] = before;
      right[i] = 3 * (after * chord[i - 1] + before * chord[i]);
    }
    double g0 = x[n - 1] - x[n - 2];
    double g1 = x[n - 2] - x[n - 3];
    lower[n - 1] = g0 + g1;
    middle[n - 1] = g1;
    right[n - 1] = (g0 * g0 * chord[n - 3] + (2 * (g0 + g1) + g0) * g1 * chord[n - 2]) / (g0 + g1);
    for (int i = 1; i < n; i++) {
      double factor = lower[i] / middle[i - 1];
      middle[i] -= factor * upper[i - 1];
      right[i] -= factor * right[i - 1];
    }
    double[] slope = new double[n];
    slope[n - 1] = right[n - 1] / middle[n - 1];
    for (int i = n - 2; i >= 0; i--) {
      slope[i] = (right[i] - upper[i] * slope[i + 1]) / middle[i];
    }
    return slope;
  }

  /** Returns whether there are no values beyond the ends. */
  public boolean isBounded() {
    return bounded;
  }

  /** Returns the arguments of the points, ascending; a copy. */
  public double[] knots() {
    return knots.clone();
  }

  /**
   * Returns one number of all polynomials, by how many points are not above the argument: one more
   * than there are points.
   *
   * @param number 0: the origin; 1 to 4: c0 to c3
   */
  public double[] numbers(int number) {
    double[] all = new double[knots.length + 1];
    for (int place = 0; place < all.length; place++) {
      all[place] = polynomials[NUMBERS * place + number];
    }
    return all;
  }

  /**
   * Returns the curve as a row of {@link org.mechservice.solver.spatial.CubicCurve}; beyond the
   * ends of a table that has no values there it is far away.
   */
  public double[] row() {
    int n = knots.length;
    double[] row = Arrays.copyOf(knots, 6 * n + NUMBERS);
    for (int number = 0; number < NUMBERS; number++) {
      double[] all = numbers(number);
      if (bounded) {
        all[0] = number == 1 ? BEYOND : 0;
        all[n] = all[0];
      }
      System.arraycopy(all, 0, row, n + number * (n + 1), n + 1);
    }
    return row;
  }

  /** Returns whether its slope jumps at the points. */
  public boolean hasCorners() {
    return straight;
  }

  /** Returns the points at which its slope jumps, ascending. */
  public double[] corners() {
    return corners(knots, straight, holds);
  }

  /**
   * Returns the points of straight lines; of other curves the ends, if they are held beyond them.
   */
  static double[] corners(double[] knots, boolean straight, boolean holds) {
    if (straight) {
      return knots.clone();
    }
    return holds ? new double[] {knots[0], knots[knots.length - 1]} : new double[0];
  }

  /** Returns the number of points that are not above an argument. */
  int place(double x) {
    return (int) NumberTable.interval(knots, 0, knots.length, x);
  }

  @Override
  public double distance(double a, double b) {
    return distance(knots, a);
  }

  static double distance(double[] knots, double x) {
    int place = (int) NumberTable.interval(knots, 0, knots.length, x);
    double before = place == 0 ? Double.POSITIVE_INFINITY : x - knots[place - 1];
    double ahead = place == knots.length ? Double.POSITIVE_INFINITY : knots[place] - x;
    return Math.min(before, ahead);
  }

  @Override
  public void bound(double from, double to, double bLow, double bHigh, Enclosure bounds) {
    bounds.set(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);
    int last = place(to);
    for (int place = place(from); place <= last; place++) {
      double first = place == 0 ? from : Math.max(from, knots[place - 1]);
      double end = place == knots.length ? to : Math.min(to, knots[place]);
      int p = NUMBERS * place;
      double a = first - polynomials[p];
      double b = end - polynomials[p];
      bounds.include(cubic(p, a));
      bounds.include(cubic(p, b));
      includeExtrema(p, a, b, bounds);
    }
    bounds.settle(Enclosure.ROUNDING_OF_TABLE);
  }

  @Override
  public String name() {
    return "CURVE";
  }

  @Override
  public boolean hasPieces() {
    return hasCorners();
  }

  @Override
  public double piece(double a, double b) {
    return place(a);
  }

  @Override
  public boolean isNarrow() {
    return !hasCorners();
  }

  @Override
  public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
    return place(aHigh) - place(aLow) <= 1;
  }

  private double cubic(int p, double d) {
    return polynomials[p + 1]
        + d * (polynomials[p + 2] + d * (polynomials[p + 3] + d * polynomials[p + 4]));
  }

  /** Includes the extrema of a cubic between a and b: the zeros of c1 + 2 c2 d + 3 c3 d². */
  private void includeExtrema(int p, double a, double b, Enclosure bounds) {
    double c1 = polynomials[p + 2];
    double c2 = polynomials[p + 3];
    double c3 = 3 * polynomials[p + 4];
    double discriminant = c2 * c2 - c1 * c3;
    if ((c2 == 0 && c3 == 0) || discriminant < 0) {
      return;
    }
    double sum = -(c2 + Math.copySign(Math.sqrt(discriminant), c2));
    double one = sum / c3;
    double other = c1 / sum;
    if (one > a && one < b) {
      bounds.include(cubic(p, one));
    }
    if (other > a && other < b) {
      bounds.include(cubic(p, other));
    }
  }

  /** Returns the value at an argument. */
  public double at(double x) {
    return value(x, x, place(x));
  }

  @Override
  public double place(double a, double b) {
    return place(a);
  }

  @Override
  public double value(double a, double b, double place) {
    boolean beyond = bounded && !(a >= knots[0] && a <= knots[knots.length - 1]);
    return beyond ? Double.NaN : cubic(NUMBERS * (int) place, a - originOf(place));
  }

  private double originOf(double place) {
    return polynomials[NUMBERS * (int) place];
  }

  @Override
  public GivenFunction slope(int argument) {
    return new Slope(this, 1);
  }

  @Override
  public GivenFunction origin() {
    return this;
  }

  /** A derivative, {@code order} times by x. */
  private record Slope(TableCurve origin, int order) implements GivenFunction {
    @Override
    public double place(double a, double b) {
      return origin.place(a);
    }

    @Override
    public double value(double a, double b, double place) {
      return origin.slopeAt(NUMBERS * (int) place, a - origin.originOf(place), order);
    }

    @Override
    public GivenFunction slope(int argument) {
      return new Slope(origin, order + 1);
    }
  }

  private double slopeAt(int p, double d, int order) {
    return slope(
        order, d, polynomials[p + 1], polynomials[p + 2], polynomials[p + 3], polynomials[p + 4]);
  }

  /** Returns a derivative of c0 + d (c1 + d (c2 + d c3)). */
  static double slope(int order, double d, double c0, double c1, double c2, double c3) {
    return switch (order) {
      case 0 -> c0 + d * (c1 + d * (c2 + d * c3));
      case 1 -> c1 + d * (2 * c2 + d * (3 * c3));
      case 2 -> 2 * c2 + d * (6 * c3);
      case 3 -> 6 * c3;
      default -> 0;
    };
  }
}
