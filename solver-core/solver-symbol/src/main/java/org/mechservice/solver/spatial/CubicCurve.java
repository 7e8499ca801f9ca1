package org.mechservice.solver.spatial;

/**
 * The closest point of a curve z = h(x) of cubics to a point, for generated code and for tables.
 *
 * <p>A row holds the curve: n ascending knots, then n + 1 origins, and n + 1 of each of the
 * coefficients c0 to c3 of the polynomials c0 + d (c1 + d (c2 + d c3)), d = x − origin, by how many
 * knots are not above x: 6 n + 5 numbers. The exported C code has the same operations.
 */
public final class CubicCurve {
  /** Parts of a cubic in each of which the derivative of the distance has one zero at most. */
  private static final int PARTS = 8;

  /** Bound of the steps to a zero: halvings of an interval down to neighbouring numbers. */
  private static final int STEPS = 1100;

  private CubicCurve() {}

  /**
   * Returns the abscissa s of the point of the curve that is closest to (x, z); the same arguments
   * give the same bits on every machine. Between knots the distance is searched where its
   * derivative, g(s) = s − x + (h(s) − z) h′(s), rises through zero. Pieces whose box is farther
   * away than a point that has been found are left out.
   *
   * @param table holds the row; not modified
   * @param first where the row begins
   * @param count its numbers
   * @return s, x where h(x) is not finite
   */
  public static double closest(double[] table, int first, int count, double x, double z) {
    int n = (count - 5) / 6;
    int here = (int) NumberTable.interval(table, first, n, x);
    int polynomials = first + n;
    double above = value(table, polynomials, n, here, x) - z;
    double least = above * above;
    if (!(least < Double.POSITIVE_INFINITY)) {
      return x;
    }
    double best = x;
    double width = Math.abs(above);
    double low = x - width;
    double high = x + width;
    int last = n;
    for (int turn = 0; turn < 2; turn++) {
      int place = turn == 0 ? here : here - 1;
      while (turn == 0 ? place <= last : place >= 0) {
        double from = place == 0 ? low : Math.max(low, table[first + place - 1]);
        double to = place == n ? high : Math.min(high, table[first + place]);
        double aside = turn == 0 ? from - x : x - to;
        if (from > to || (aside > 0 && aside * aside >= least)) {
          break;
        }
        double found = ofPiece(table, polynomials, n, place, from, to, x, z, best, least);
        if (found != best) {
          best = found;
          least = square(table, polynomials, n, place, best, x, z);
        }
        place += turn == 0 ? 1 : -1;
      }
    }
    return best;
  }

  private static double ofPiece(
      double[] table,
      int at,
      int n,
      int place,
      double from,
      double to,
      double x,
      double z,
      double known,
      double leastKnown) {
    double c1 = table[at + 2 * (n + 1) + place];
    double c2 = table[at + 3 * (n + 1) + place];
    double c3 = table[at + 4 * (n + 1) + place];
    double origin = table[at + place];
    double third = (to - from) / 3;
    double atFrom = value(table, at, n, place, from);
    double atTo = value(table, at, n, place, to);
    double slopeFrom = c1 + (from - origin) * (2 * c2 + (from - origin) * (3 * c3));
    double slopeTo = c1 + (to - origin) * (2 * c2 + (to - origin) * (3 * c3));
    double one = atFrom + third * slopeFrom;
    double two = atTo - third * slopeTo;
    // the cubic lies between the least and the largest of its Bernstein coefficients
    double lowest = Math.min(Math.min(atFrom, atTo), Math.min(one, two));
    double highest = Math.max(Math.max(atFrom, atTo), Math.max(one, two));
    double off = Math.max(0, Math.max(z - highest, lowest - z));
    double aside = Math.max(0, Math.max(from - x, x - to));
    if (off * off + aside * aside >= leastKnown) {
      return known;
    }
    double bendFrom = 2 * c2 + (from - origin) * (6 * c3);
    double bendTo = 2 * c2 + (to - origin) * (6 * c3);
    double most = Math.max(Math.abs(bendFrom), Math.abs(bendTo));
    double farthest = Math.max(highest - z, z - lowest);
    int parts = most * farthest < 1 ? 1 : PARTS;
    if (parts == 1 && from <= x && x < to) {
      // at least as close as what is known, the point at x, even if rounding hides it
      return zero(table, at, n, place, from, to, x, z);
    }
    double best = known;
    double least = leastKnown;
    double start = from;
    for (int i = 1; i <= parts; i++) {
      double end = i == parts ? to : from + (to - from) * i / parts;
      double s = zero(table, at, n, place, start, end, x, z);
      double square = square(table, at, n, place, s, x, z);
      if (square < least) {
        least = square;
        best = s;
      }
      start = end;
    }
    return best;
  }

  /** Returns where g rises through zero; an end of the interval if g has one sign. */
  private static double zero(
      double[] table, int at, int n, int place, double from, double to, double x, double z) {
    double c0 = table[at + n + 1 + place];
    double c1 = table[at + 2 * (n + 1) + place];
    double c2 = table[at + 3 * (n + 1) + place];
    double c3 = table[at + 4 * (n + 1) + place];
    double origin = table[at + place];
    double low = from;
    double high = to;
    double s = x < from ? from : x > to ? to : x;
    for (int i = 0; i < STEPS; i++) {
      double d = s - origin;
      double above = c0 + d * (c1 + d * (c2 + d * c3)) - z;
      double slope = c1 + d * (2 * c2 + d * (3 * c3));
      double bend = 2 * c2 + d * (6 * c3);
      double g = s - x + above * slope;
      double rise = 1 + slope * slope + above * bend;
      if (g > 0) {
        high = s;
      } else {
        low = s;
      }
      double next = s - g / rise;
      if (!(rise > 0) || !(next > low && next < high)) {
        // the first step may leave the interval for good: to its end
        boolean toEnd = rise > 0 && i == 0;
        next = toEnd && next >= to ? to : toEnd && next <= from ? from : 0.5 * (low + high);
        if (!toEnd && (next <= low || next >= high)) {
          break;
        }
      }
      if (next == s) {
        break;
      }
      s = next;
    }
    return s;
  }

  private static double value(double[] table, int at, int n, int place, double x) {
    double d = x - table[at + place];
    double inner = table[at + 3 * (n + 1) + place] + d * table[at + 4 * (n + 1) + place];
    return table[at + n + 1 + place] + d * (table[at + 2 * (n + 1) + place] + d * inner);
  }

  private static double square(
      double[] table, int at, int n, int place, double s, double x, double z) {
    double above = value(table, at, n, place, s) - z;
    return (s - x) * (s - x) + above * above;
  }
}
