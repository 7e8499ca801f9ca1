package org.mechservice.solver.expression;

import org.mechservice.solver.spatial.Powers;

/**
 * Bounds of all values of a tape, over a box of leaves or along a short way.
 *
 * <p>Along a way the values at its start, middle and end are given. An operation that changes
 * evenly stays near the parabola through its three values, with a margin of {@value #MARGIN} of its
 * bow; the others are bounded by interval arithmetic. A parabola passes its points by 1/8 of the
 * second difference at most, so that the margin covers three times as much for what is none.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
final class TapeBounds {
  /** Margin beside three values, relative to their second difference. */
  private static final double MARGIN = 0.5;

  /** Change of an argument within which exponential and hyperbolic functions change evenly. */
  private static final double EVEN = 0.5;

  /** Factor within which a divisor may change for its quotient to change evenly. */
  private static final double RATIO = 2;

  /** Exponent below which an exponential is nothing; twice the argument beyond which tanh is 1. */
  private static final double NOTHING = -40;

  private final Tape tape;
  private final Enclosure enclosure = new Enclosure();

  /** Lowest and highest value of each slot. */
  final double[] low;

  final double[] high;

  /** Slots whose way is no parabola. */
  private final boolean[] rough;

  /** Steps that are no choices and can change much while their arguments hardly do. */
  private final boolean[] narrow;

  TapeBounds(Tape tape) {
    this.tape = tape;
    low = tape.initial.clone();
    high = tape.initial.clone();
    rough = new boolean[low.length];
    narrow = new boolean[tape.operation.length];
    for (int i = 0; i < narrow.length; i++) {
      narrow[i] = isNarrow(tape.operation[i]);
    }
  }

  private static boolean isNarrow(TapeStep step) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case DIVIDE, TAN, ATAN, EXP, SINH, COSH, TANH, POWER -> true;
        case ADD,
            MULTIPLY,
            NEGATE,
            SQUARE,
            SQRT,
            ABS,
            SIN,
            COS,
            ASIN,
            ACOS,
            ATAN2,
            LOG,
            MIN,
            MAX,
            SIGNUM,
            HYPOT,
            FLOOR,
            STEP,
            SMOOTH_STEP ->
            false;
      };
    }
    return !TapePieces.hasPieces(step);
  }

  /** Returns whether a step can change much while its arguments hardly do, and is no choice. */
  boolean isNarrow(int step) {
    return narrow[step];
  }

  /** Bounds all values over the box that the bounds of the leaves are. */
  void ofBox() {
    for (int i = 0; i < narrow.length; i++) {
      enclose(i, tape.kind[i], tape.first[i], tape.second[i], tape.target[i]);
    }
  }

  /** Bounds all values along a way, of which the values at three points are given. */
  void ofWay(double[] start, double[] middle, double[] end) {
    for (int slot : tape.leafSlot) {
      follow(slot, start, middle, end);
    }
    byte[] kind = tape.kind;
    int[] first = tape.first;
    int[] second = tape.second;
    int[] target = tape.target;
    for (int i = 0; i < kind.length; i++) {
      int a = first[i];
      int b = second[i];
      boolean uneven = rough[a] || rough[b] || !changesEvenly(i, kind[i], a, b);
      rough[target[i]] = uneven;
      if (uneven) {
        enclose(i, kind[i], a, b, target[i]);
      } else {
        follow(target[i], start, middle, end);
      }
    }
  }

  private void follow(int slot, double[] start, double[] middle, double[] end) {
    double a = start[slot];
    double m = middle[slot];
    double b = end[slot];
    double bow = MARGIN * Math.abs(a - 2 * m + b);
    double least = a < m ? a : m;
    double most = a < m ? m : a;
    low[slot] = (least < b ? least : b) - bow;
    high[slot] = (most < b ? b : most) + bow;
  }

  private void enclose(int i, int kind, int a, int b, int target) {
    if (kind == Tape.NEGATION) {
      low[target] = -high[a];
      high[target] = -low[a];
      return;
    } else if (kind == Tape.SUM) {
      enclosure.ofSum(low[a], high[a], low[b], high[b]);
    } else if (kind == Tape.PRODUCT) {
      enclosure.ofProduct(low[a], high[a], low[b], high[b]);
    } else {
      enclosure.of(tape.operation[i], low[a], high[a], low[b], high[b]);
    }
    low[target] = enclosure.low;
    high[target] = enclosure.high;
  }

  /** Returns whether an operation changes evenly within the bounds of its operands. */
  private boolean changesEvenly(int i, int kind, int a, int b) {
    return switch (kind) {
      case Tape.SUM, Tape.NEGATION -> true;
      // curved factors that pass through zero make a corner that no three points show
      case Tape.PRODUCT -> !(reachesZero(a) && reachesZero(b));
      case Tape.SQUARE -> !reachesZero(a);
      default -> otherChangesEvenly(i, a, b);
    };
  }

  private boolean otherChangesEvenly(int i, int a, int b) {
    TapeStep step = tape.operation[i];
    if (narrow[i]) {
      if (step == Operation.POWER) {
        enclose(i, Tape.OTHER, a, b, tape.target[i]);
      }
      return isEven(i);
    } else if (!(step instanceof Operation)) {
      return isDecided(i);
    }
    return switch ((Operation) step) {
      case SIN, COS -> high[a] - low[a] <= EVEN;
      case SQRT, LOG -> changesLittle(low[a], high[a], RATIO);
      case ASIN, ACOS -> high[a] < EVEN && low[a] > -EVEN;
      case HYPOT -> changesLittle(low[a], high[a], RATIO) || changesLittle(low[b], high[b], RATIO);
      case ATAN2 -> changesLittle(low[b], high[b], RATIO) && low[b] > 0;
      default -> isDecided(i);
    };
  }

  private boolean reachesZero(int slot) {
    return low[slot] <= 0 && high[slot] >= 0;
  }

  private static boolean changesLittle(double lowest, double highest, double ratio) {
    return lowest > 0 ? highest <= ratio * lowest : highest < 0 && lowest >= ratio * highest;
  }

  /** Returns whether a step that can be narrow changes evenly within the bounds. */
  boolean isEven(int i) {
    TapeStep step = tape.operation[i];
    double aLow = low[tape.first[i]];
    double aHigh = high[tape.first[i]];
    double bLow = low[tape.second[i]];
    double bHigh = high[tape.second[i]];
    if (step instanceof Operation operation) {
      return switch (operation) {
        case DIVIDE -> changesLittle(bLow, bHigh, RATIO);
        case EXP -> aHigh - aLow <= EVEN || aHigh < NOTHING;
        case TANH -> aHigh - aLow <= EVEN || 2 * aHigh < NOTHING || 2 * aLow > -NOTHING;
        case ATAN -> aHigh - aLow <= EVEN || changesLittle(aLow, aHigh, RATIO);
        case POWER ->
            high[tape.target[i]] < StrictMath.exp(NOTHING)
                || changesLittle(aLow, aHigh, Powers.power(RATIO, 1 / Math.max(1, bHigh)));
        default -> aHigh - aLow <= EVEN;
      };
    }
    return step instanceof TableCurve curve
        ? curve.place(aHigh) - curve.place(aLow) <= 1
        : ((MapSurface) step).crossings(aLow, aHigh, bLow, bHigh) <= 1;
  }

  /** Returns whether a choice takes one piece within the bounds. */
  boolean isDecided(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    TapeStep step = tape.operation[i];
    if (step == Operation.MIN || step == Operation.MAX) {
      boolean apart = high[a] < low[b] || low[a] >= high[b];
      return apart || (isZero(a) && isZero(b));
    }
    return TapePieces.piece(step, low[a], low[b]) == TapePieces.piece(step, high[a], high[b]);
  }

  /** Returns whether a slot is exactly zero. */
  boolean isZero(int slot) {
    return low[slot] == 0 && high[slot] == 0;
  }
}
