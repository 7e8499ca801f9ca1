package org.mechservice.solver.symbol;

import java.util.function.DoubleUnaryOperator;
import org.mechservice.solver.spatial.Powers;

/**
 * Bounds of the values that operations take while their operands run through intervals. Rounding is
 * included; where an operation is not defined on a part of its operands, that part is left out, and
 * what has no bound is infinite.
 *
 * <p>R. E. Moore, <i>Interval Analysis</i>, Prentice-Hall 1966.
 */
public final class Enclosure {
  /** Rounding by which the values of an operation may differ, relative to their size. */
  public static final double ROUNDING = 4 * 0x1p-52;

  /** The same of a polynomial, whose terms may be larger than their sum. */
  public static final double ROUNDING_OF_TABLE = 64 * 0x1p-52;

  /** Factor within which a divisor may change for its quotient to change evenly. */
  static final double RATIO = 2;

  private double low;
  private double high;

  /** Returns the lower of the bounds found last. */
  public double low() {
    return low;
  }

  /** Returns the upper of the bounds found last. */
  public double high() {
    return high;
  }

  /** Returns whether an interval is off zero, and a quotient by what is in it changes evenly. */
  public static boolean changesLittle(double lowest, double highest) {
    return changesLittle(lowest, highest, RATIO);
  }

  static boolean changesLittle(double lowest, double highest, double ratio) {
    return lowest > 0 ? highest <= ratio * lowest : highest < 0 && lowest >= ratio * highest;
  }

  /** Finds the bounds of a sum, with its rounding. */
  public void ofSum(double aLow, double aHigh, double bLow, double bHigh) {
    set(aLow + bLow, aHigh + bHigh);
    settle(ROUNDING);
  }

  /** Finds the bounds of a product with its rounding. */
  public void ofProduct(double aLow, double aHigh, double bLow, double bHigh) {
    product(aLow, aHigh, bLow, bHigh);
    settle(ROUNDING);
  }

  /**
   * Widens the bounds by the rounding of both ways of evaluation, relative to their size; what is
   * exactly 0 stays so. Bounds that are none become infinite.
   *
   * @param rounding 0 of what does not round
   */
  public void settle(double rounding) {
    if (!(low <= high)) {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    } else if (rounding > 0) {
      double error = rounding * Math.max(Math.abs(low), Math.abs(high)) + Double.MIN_NORMAL;
      low -= low == 0 ? 0 : error;
      high += high == 0 ? 0 : error;
    }
  }

  /** Sets the bounds. */
  public void set(double lowest, double highest) {
    low = lowest;
    high = highest;
  }

  /**
   * Sets the bounds of a value that counts on one side only.
   *
   * @param taken whether the side of the value is met
   * @param left whether the other side is met, where 0 stands
   */
  void part(boolean taken, boolean left, double lowest, double highest) {
    if (!taken) {
      set(0, 0);
    } else if (!left) {
      set(lowest, highest);
    } else {
      set(Math.min(0, lowest), Math.max(0, highest));
    }
  }

  /** Widens the bounds to include a value. */
  public void include(double value) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }

  /** Finds the bounds of what does not fall. */
  void rising(DoubleUnaryOperator f, double aLow, double aHigh) {
    set(f.applyAsDouble(aLow), f.applyAsDouble(aHigh));
  }

  /** Finds the bounds of a product without its rounding. */
  public void product(double aLow, double aHigh, double bLow, double bHigh) {
    double one = times(aLow, bLow);
    double two = times(aLow, bHigh);
    double three = times(aHigh, bLow);
    double four = times(aHigh, bHigh);
    double least = one < two ? one : two;
    double most = one < two ? two : one;
    double less = three < four ? three : four;
    double more = three < four ? four : three;
    set(least < less ? least : less, most < more ? more : most);
  }

  /** A factor 0 is exactly 0 all over the interval, also where the other has no bound. */
  private static double times(double a, double b) {
    return a == 0 || b == 0 ? 0 : a * b;
  }

  /** Finds the bounds of a quotient without its rounding. */
  public void quotient(double aLow, double aHigh, double bLow, double bHigh) {
    if (bLow > 0 || bHigh < 0) {
      product(aLow, aHigh, 1 / bHigh, 1 / bLow);
    } else if (aLow == 0 && aHigh == 0) {
      set(0, 0);
    } else {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }
  }

  /** Finds the bounds of a square without its rounding. */
  public void square(double aLow, double aHigh) {
    absolute(aLow, aHigh);
    set(low * low, high * high);
  }

  /** Finds the bounds of √(a² + b²) without its rounding. */
  void length(double aLow, double aHigh, double bLow, double bHigh) {
    square(aLow, aHigh);
    double lowest = low;
    double highest = high;
    square(bLow, bHigh);
    set(Math.sqrt(lowest + low), Math.sqrt(highest + high));
  }

  /** Finds the bounds of sizes. */
  void absolute(double aLow, double aHigh) {
    if (aLow >= 0) {
      set(aLow, aHigh);
    } else if (aHigh <= 0) {
      set(-aHigh, -aLow);
    } else {
      set(0, Math.max(-aLow, aHigh));
    }
  }

  /** Bounds of sine or cosine: 1 where a crest lies inside, −1 half a turn further. */
  void wave(DoubleUnaryOperator f, double aLow, double aHigh, double crest) {
    if (!(aHigh - aLow < 2 * Math.PI)) {
      set(-1, 1);
      return;
    }
    double first = f.applyAsDouble(aLow);
    double last = f.applyAsDouble(aHigh);
    set(Math.min(first, last), Math.max(first, last));
    if (holdsMultiple(aLow - crest, aHigh - crest, 2 * Math.PI)) {
      high = 1;
    }
    if (holdsMultiple(aLow - crest - Math.PI, aHigh - crest - Math.PI, 2 * Math.PI)) {
      low = -1;
    }
  }

  private static boolean holdsMultiple(double from, double to, double of) {
    return Math.floor(to / of) > Math.floor(from / of) || from / of == Math.floor(from / of);
  }

  /** The angle of a box of points (x, y) = (b, a): at its corners, unless the cut lies in it. */
  void angle(double aLow, double aHigh, double bLow, double bHigh) {
    if (bLow <= 0 && aLow <= 0 && aHigh >= 0) {
      set(-Math.PI, Math.PI);
      return;
    }
    set(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);
    include(StrictMath.atan2(aLow, bLow));
    include(StrictMath.atan2(aLow, bHigh));
    include(StrictMath.atan2(aHigh, bLow));
    include(StrictMath.atan2(aHigh, bHigh));
  }

  /** A base that may be negative takes a whole exponent; other parts of it count as undefined. */
  void power(double aLow, double aHigh, double bLow, double bHigh) {
    boolean whole = bLow == bHigh && bLow == Math.rint(bLow);
    if (whole && aLow < 0) {
      wholePower(aLow, aHigh, bLow);
      return;
    }
    double lowest = Math.max(0, aLow);
    double highest = Math.max(0, aHigh);
    set(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);
    include(Powers.power(lowest, bLow));
    include(Powers.power(lowest, bHigh));
    include(Powers.power(highest, bLow));
    include(Powers.power(highest, bHigh));
  }

  private void wholePower(double aLow, double aHigh, double n) {
    if (n < 0 && aHigh >= 0) {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
      return;
    }
    double first = Powers.power(aLow, n);
    double last = Powers.power(aHigh, n);
    set(Math.min(first, last), Math.max(first, last));
    if (n % 2 == 0 && aHigh > 0) {
      low = 0;
    }
  }
}
