package org.mechservice.solver.expression;

import java.util.function.DoubleUnaryOperator;
import org.mechservice.solver.spatial.Powers;

/**
 * Bounds of the values that operations take while their operands run through intervals. Rounding is
 * included; where an operation is not defined on a part of its operands, that part is left out, and
 * what has no bound is infinite.
 *
 * <p>R. E. Moore, <i>Interval Analysis</i>, Prentice-Hall 1966.
 */
final class Enclosure {
  /** Rounding by which the values of an operation may differ, relative to their size. */
  private static final double ROUNDING = 4 * 0x1p-52;

  /** The same of a polynomial, whose terms may be larger than their sum. */
  private static final double ROUNDING_OF_TABLE = 64 * 0x1p-52;

  /** The bounds found last. */
  double low;

  double high;

  /** Finds the bounds of a step for a in [aLow, aHigh] and b in [bLow, bHigh]. */
  void of(TapeStep step, double aLow, double aHigh, double bLow, double bHigh) {
    if (step instanceof Operation operation) {
      of(operation, aLow, aHigh, bLow, bHigh);
    } else if (step instanceof TableCurve curve) {
      curve.bounds(aLow, aHigh, this);
    } else {
      ((MapSurface) step).bounds(aLow, aHigh, bLow, bHigh, this);
    }
    if (!rounds(step)) {
      settle(0);
    } else {
      settle(step instanceof Operation ? ROUNDING : ROUNDING_OF_TABLE);
    }
  }

  /** Finds the bounds of a sum, as {@link #of} does. */
  void ofSum(double aLow, double aHigh, double bLow, double bHigh) {
    set(aLow + bLow, aHigh + bHigh);
    settle(ROUNDING);
  }

  /** Finds the bounds of a product, as {@link #of} does. */
  void ofProduct(double aLow, double aHigh, double bLow, double bHigh) {
    product(aLow, aHigh, bLow, bHigh);
    settle(ROUNDING);
  }

  /** Returns whether an operation rounds; the others give one of a few values, or an operand. */
  private static boolean rounds(TapeStep step) {
    return !(step instanceof Operation operation)
        || switch (operation) {
          case NEGATE, ABS, MIN, MAX, SIGNUM, FLOOR, STEP -> false;
          case ADD,
              MULTIPLY,
              DIVIDE,
              SQUARE,
              SQRT,
              SIN,
              COS,
              TAN,
              ASIN,
              ACOS,
              ATAN,
              ATAN2,
              EXP,
              LOG,
              SINH,
              COSH,
              TANH,
              HYPOT,
              SMOOTH_STEP,
              POWER ->
              true;
        };
  }

  /**
   * Widens the bounds by the rounding of both ways of evaluation, relative to their size; what is
   * exactly 0 stays so. Bounds that are none become infinite.
   */
  private void settle(double rounding) {
    if (!(low <= high)) {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    } else if (rounding > 0) {
      double error = rounding * Math.max(Math.abs(low), Math.abs(high)) + Double.MIN_NORMAL;
      low -= low == 0 ? 0 : error;
      high += high == 0 ? 0 : error;
    }
  }

  void set(double lowest, double highest) {
    low = lowest;
    high = highest;
  }

  /** Widens the bounds to include a value. */
  void include(double value) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }

  private void of(Operation operation, double aLow, double aHigh, double bLow, double bHigh) {
    switch (operation) {
      case ADD -> set(aLow + bLow, aHigh + bHigh);
      case MULTIPLY -> product(aLow, aHigh, bLow, bHigh);
      case DIVIDE -> quotient(aLow, aHigh, bLow, bHigh);
      case NEGATE -> set(-aHigh, -aLow);
      case SQUARE -> square(aLow, aHigh);
      case SQRT -> set(Math.sqrt(Math.max(0, aLow)), Math.sqrt(Math.max(0, aHigh)));
      case ABS -> absolute(aLow, aHigh);
      case SIN -> wave(StrictMath.sin(aLow), StrictMath.sin(aHigh), aLow, aHigh, 0.5 * Math.PI);
      case COS -> wave(StrictMath.cos(aLow), StrictMath.cos(aHigh), aLow, aHigh, 0);
      case TAN -> tangent(aLow, aHigh);
      case ASIN -> set(StrictMath.asin(unit(aLow)), StrictMath.asin(unit(aHigh)));
      case ACOS -> set(StrictMath.acos(unit(aHigh)), StrictMath.acos(unit(aLow)));
      case ATAN -> rising(StrictMath::atan, aLow, aHigh);
      case ATAN2 -> angle(aLow, aHigh, bLow, bHigh);
      case EXP -> rising(StrictMath::exp, aLow, aHigh);
      case LOG -> set(StrictMath.log(Math.max(0, aLow)), StrictMath.log(Math.max(0, aHigh)));
      case MIN -> set(Math.min(aLow, bLow), Math.min(aHigh, bHigh));
      case MAX -> set(Math.max(aLow, bLow), Math.max(aHigh, bHigh));
      case SINH -> rising(StrictMath::sinh, aLow, aHigh);
      case COSH -> {
        absolute(aLow, aHigh);
        rising(StrictMath::cosh, low, high);
      }
      case TANH -> rising(StrictMath::tanh, aLow, aHigh);
      case SIGNUM -> set(Math.signum(aLow), Math.signum(aHigh));
      case HYPOT -> {
        square(aLow, aHigh);
        double lowest = low;
        double highest = high;
        square(bLow, bHigh);
        set(Math.sqrt(lowest + low), Math.sqrt(highest + high));
      }
      case FLOOR -> set(Math.floor(aLow), Math.floor(aHigh));
      case STEP -> set(aLow < 0 ? 0 : 1, aHigh < 0 ? 0 : 1);
      case SMOOTH_STEP -> set(smoothStep(aLow), smoothStep(aHigh));
      case POWER -> power(aLow, aHigh, bLow, bHigh);
    }
  }

  private void rising(DoubleUnaryOperator f, double aLow, double aHigh) {
    set(f.applyAsDouble(aLow), f.applyAsDouble(aHigh));
  }

  /** Finds the bounds of a product without its rounding. */
  void product(double aLow, double aHigh, double bLow, double bHigh) {
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

  private void quotient(double aLow, double aHigh, double bLow, double bHigh) {
    if (bLow > 0 || bHigh < 0) {
      product(aLow, aHigh, 1 / bHigh, 1 / bLow);
    } else if (aLow == 0 && aHigh == 0) {
      set(0, 0);
    } else {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }
  }

  private void square(double aLow, double aHigh) {
    absolute(aLow, aHigh);
    set(low * low, high * high);
  }

  private void absolute(double aLow, double aHigh) {
    if (aLow >= 0) {
      set(aLow, aHigh);
    } else if (aHigh <= 0) {
      set(-aHigh, -aLow);
    } else {
      set(0, Math.max(-aLow, aHigh));
    }
  }

  /** Bounds of sine or cosine: 1 where a crest lies inside, −1 half a turn further. */
  private void wave(double first, double last, double aLow, double aHigh, double crest) {
    if (!(aHigh - aLow < 2 * Math.PI)) {
      set(-1, 1);
      return;
    }
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

  private void tangent(double aLow, double aHigh) {
    if (aHigh - aLow >= Math.PI
        || holdsMultiple(aLow + 0.5 * Math.PI, aHigh + 0.5 * Math.PI, Math.PI)) {
      set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    } else {
      rising(StrictMath::tan, aLow, aHigh);
    }
  }

  private static double unit(double a) {
    return Math.max(-1, Math.min(1, a));
  }

  /** The angle of a box of points (x, y) = (b, a): at its corners, unless the cut lies in it. */
  private void angle(double aLow, double aHigh, double bLow, double bHigh) {
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

  private static double smoothStep(double a) {
    double s = Math.max(0, Math.min(1, a));
    return s * s * (3 - 2 * s);
  }

  /** A base that may be negative takes a whole exponent; other parts of it count as undefined. */
  private void power(double aLow, double aHigh, double bLow, double bHigh) {
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
