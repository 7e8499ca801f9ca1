package org.mechservice.solver.expression;

import org.mechservice.solver.symbol.Corners;
import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.WatchedStep;

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

  private final Tape tape;
  private final Enclosure enclosure = new Enclosure();

  /** Lowest and highest value of each slot. */
  final double[] low;

  final double[] high;

  /** Slots whose way is no parabola. */
  private final boolean[] rough;

  /** Steps that are no choices and can change much while their arguments hardly do. */
  private final boolean[] narrow;

  /** Steps that are smooth whatever their operands are. */
  private final boolean[] smooth;

  TapeBounds(Tape tape) {
    this.tape = tape;
    low = tape.initial.clone();
    high = tape.initial.clone();
    rough = new boolean[low.length];
    narrow = new boolean[tape.operation.length];
    smooth = new boolean[tape.operation.length];
    for (int i = 0; i < narrow.length; i++) {
      smooth[i] = tape.operation[i] == MathFunction.SMOOTH;
      narrow[i] = tape.operation[i].isNarrow();
    }
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
      boolean uneven = !smooth[i] && (rough[a] || rough[b] || !changesEvenly(i, kind[i], a, b));
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
    } else if (kind == Tape.DIFFERENCE) {
      enclosure.ofSum(low[a], high[a], -high[b], -low[b]);
    } else if (kind == Tape.PRODUCT) {
      enclosure.ofProduct(low[a], high[a], low[b], high[b]);
    } else {
      tape.operation[i].bound(low[a], high[a], low[b], high[b], enclosure);
    }
    low[target] = enclosure.low();
    high[target] = enclosure.high();
  }

  /** Returns whether an operation changes evenly within the bounds of its operands. */
  private boolean changesEvenly(int i, int kind, int a, int b) {
    return switch (kind) {
      case Tape.SUM, Tape.DIFFERENCE, Tape.NEGATION -> true;
      // curved factors that pass through zero make a corner that no three points show
      case Tape.PRODUCT -> !(reachesZero(a) && reachesZero(b));
      case Tape.SQUARE -> !reachesZero(a);
      default -> otherChangesEvenly(i, a, b);
    };
  }

  private boolean otherChangesEvenly(int i, int a, int b) {
    WatchedStep step = tape.operation[i];
    if (step.hasPieces() && !narrow[i]) {
      return isDecided(i);
    }
    if (step instanceof MathFunction function && function.isEvenByValue()) {
      enclose(i, Tape.OTHER, a, b, tape.target[i]);
    }
    return isEven(i);
  }

  private boolean reachesZero(int slot) {
    return low[slot] <= 0 && high[slot] >= 0;
  }

  /** Returns whether a step that has no pieces changes evenly within the bounds. */
  boolean isEven(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    return tape.operation[i].isEven(low[a], high[a], low[b], high[b], high[tape.target[i]]);
  }

  /** Returns whether a choice takes one piece within the bounds. */
  boolean isDecided(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    WatchedStep step = tape.operation[i];
    if (step instanceof MathFunction function && function.corners() == Corners.EQUAL) {
      boolean apart = high[a] < low[b] || low[a] >= high[b];
      return apart || (isZero(a) && isZero(b));
    }
    return step.piece(low[a], low[b]) == step.piece(high[a], high[b]);
  }

  /** Returns whether a slot is exactly zero. */
  boolean isZero(int slot) {
    return low[slot] == 0 && high[slot] == 0;
  }
}
