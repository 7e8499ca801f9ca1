package org.mechservice.solver.integration;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;

/**
 * ∂f/∂y by one-sided differences, one evaluation per column, or per group of columns of a band that
 * share no row.
 *
 * <p>Column j is differenced over δ_j = share_j max(|y_j|, threshold_j), in the direction in which
 * y_j is about to move. The share starts at the root of the round-off and is adapted from one
 * Jacobian to the next: where the largest change of f is so small a part of f that round-off eats
 * it, the share grows, at once and with a second difference if nothing else is left of it; where
 * the change is large, the share shrinks for the sake of curvature. Salane, SAND86-1319, 1986. A
 * value that is not finite makes the column be differenced to the other side.
 */
final class JacobianDifferences {
  private static final double ROUNDOFF = Math.ulp(1.0);
  private static final double FIRST_SHARE = Math.sqrt(ROUNDOFF);
  private static final double SMALLEST_SHARE = power(0.78);
  private static final double LARGEST_SHARE = 0.1;

  /** Changes, relative to f: lost in round-off, poor, and too large for a straight line. */
  private static final double LOST = power(0.875);

  private static final double POOR = power(0.75);
  private static final double LARGE = power(0.25);

  /** Factor of a share after a poor change, its reciprocal after a large one. */
  private static final double ADAPTATION = 10;

  private final MatrixLayout layout;
  private final double[] threshold;

  /** Share of each column, the one for the next Jacobian, and the increment δ, length n. */
  private final double[] share;

  private final double[] nextShare;
  private final double[] increment;

  /** Whether the change in a column was lost in round-off, length n. */
  private final boolean[] lost;

  /** f at the point, the point moved, and f there, length n. */
  private final double[] base;

  private final double[] moved;
  private final double[] movedDerivative;

  private boolean baseKnown;

  /** Group of columns to be differenced next. */
  private int group;

  private int notFiniteComponent;

  /**
   * @param threshold size below which a component is negligible; not modified
   */
  JacobianDifferences(MatrixLayout layout, double[] threshold) {
    int n = layout.dimension();
    this.layout = layout;
    this.threshold = threshold;
    share = new double[n];
    Arrays.fill(share, FIRST_SHARE);
    nextShare = share.clone();
    increment = new double[n];
    lost = new boolean[n];
    base = new double[n];
    moved = new double[n];
    movedDerivative = new double[n];
  }

  private static double power(double exponent) {
    return StrictMath.pow(ROUNDOFF, exponent);
  }

  /** Tells f at the point at which the next Jacobian will be formed. */
  void knowDerivative(double[] derivative) {
    System.arraycopy(derivative, 0, base, 0, base.length);
    baseKnown = true;
  }

  /**
   * Forms the Jacobian; after {@link Attempt#STOPPED} the next call goes on where this one stopped.
   *
   * @param fy overwritten
   */
  Attempt evaluate(RightHandSide equations, double t, double[] y, double[] fy) {
    Attempt attempt = continueEvaluation(equations, t, y, fy);
    if (attempt != Attempt.STOPPED) {
      baseKnown = false;
      group = 0;
      System.arraycopy(nextShare, 0, share, 0, share.length);
    }
    return attempt;
  }

  private Attempt continueEvaluation(RightHandSide equations, double t, double[] y, double[] fy) {
    if (!baseKnown) {
      if (!equations.evaluate(t, y, base)) {
        return Attempt.STOPPED;
      }
      if (!finite(base)) {
        return Attempt.NOT_FINITE;
      }
      baseKnown = true;
    }
    System.arraycopy(y, 0, moved, 0, moved.length);
    int groups = Math.min(layout.columnDistance(), layout.dimension());
    for (; group < groups; group++) {
      Attempt attempt = differenceGroup(equations, t, y, fy);
      if (attempt != Attempt.PASSED) {
        return attempt;
      }
    }
    return Attempt.PASSED;
  }

  private Attempt differenceGroup(RightHandSide equations, double t, double[] y, double[] fy) {
    moveGroup(y, 1);
    if (!equations.evaluate(t, moved, movedDerivative)) {
      return Attempt.STOPPED;
    }
    if (!finite(movedDerivative)) {
      moveGroup(y, -1);
      if (!equations.evaluate(t, moved, movedDerivative)) {
        return Attempt.STOPPED;
      }
      if (!finite(movedDerivative)) {
        return Attempt.NOT_FINITE;
      }
    }
    for (int j = group; j < share.length; j += layout.columnDistance()) {
      moved[j] = y[j];
      double change = writeColumn(j, fy);
      lost[j] = judge(j, share[j], change);
    }
    return repeatLost(equations, t, y, fy);
  }

  /** Moves the columns of the group; after a stop the same way again. */
  private void moveGroup(double[] y, int sign) {
    for (int j = group; j < share.length; j += layout.columnDistance()) {
      move(j, y, sign, share[j]);
    }
  }

  private void move(int j, double[] y, int sign, double withShare) {
    double direction = base[j] >= 0 ? sign : -sign;
    double size = withShare * Math.max(Math.abs(y[j]), threshold[j]);
    moved[j] = y[j] + direction * size;
    increment[j] = moved[j] - y[j];
    if (increment[j] == 0) {
      moved[j] = y[j] + direction * Math.max(Math.ulp(y[j]), threshold[j]);
      increment[j] = moved[j] - y[j];
    }
  }

  /** Writes the difference quotients of column j; returns the largest change of f. */
  private double writeColumn(int j, double[] fy) {
    double largest = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      double change = movedDerivative[i] - base[i];
      fy[layout.index(i, j)] = change / increment[j];
      largest = Math.max(largest, Math.abs(change));
    }
    return largest;
  }

  /** Adapts the share of column j; returns whether its change was lost in round-off. */
  private boolean judge(int j, double used, double change) {
    int row = rowOf(change, j);
    double here = Math.abs(base[row]);
    double there = Math.abs(movedDerivative[row]);
    double size = Math.max(here, there);
    boolean comparable = change == 0 || (here != 0 && there != 0);
    nextShare[j] = used;
    if (comparable && change <= POOR * size) {
      nextShare[j] = Math.min(LARGEST_SHARE, ADAPTATION * used);
    } else if (comparable && change > LARGE * size) {
      nextShare[j] = Math.max(SMALLEST_SHARE, used / ADAPTATION);
    }
    return comparable && change <= LOST * size;
  }

  private int rowOf(double change, int j) {
    int row = layout.firstRow(j);
    while (row < layout.lastRow(j) && Math.abs(movedDerivative[row] - base[row]) != change) {
      row++;
    }
    return row;
  }

  private Attempt repeatLost(RightHandSide equations, double t, double[] y, double[] fy) {
    for (int j = group; j < share.length; j += layout.columnDistance()) {
      double larger = Math.min(Math.sqrt(share[j]), LARGEST_SHARE);
      if (!lost[j] || larger == share[j]) {
        continue;
      }
      double slope = steepest(j, fy);
      move(j, y, 1, larger);
      if (!equations.evaluate(t, moved, movedDerivative)) {
        return Attempt.STOPPED;
      }
      moved[j] = y[j];
      if (finite(movedDerivative) && larger * steepestMoved(j) >= slope) {
        judge(j, larger, writeColumn(j, fy));
      }
    }
    return Attempt.PASSED;
  }

  private double steepest(int j, double[] fy) {
    double slope = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      slope = Math.max(slope, Math.abs(fy[layout.index(i, j)]));
    }
    return slope;
  }

  private double steepestMoved(int j) {
    double change = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      change = Math.max(change, Math.abs(movedDerivative[i] - base[i]));
    }
    return change / Math.abs(increment[j]);
  }

  private boolean finite(double[] x) {
    notFiniteComponent = RightHandSide.firstNotFinite(x);
    return notFiniteComponent < 0;
  }

  /** Returns the first component of f that was not finite. */
  int notFiniteComponent() {
    return notFiniteComponent;
  }
}
