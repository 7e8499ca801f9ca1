package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * The derivatives ∂f/∂x of a vector function by one-sided differences, one evaluation per column,
 * or per group of columns that share no row ({@link ColumnGroups}). Columns of passive components
 * are left zero.
 *
 * <p>Column j is differenced over δ_j = share_j max(|x_j|, threshold_j), in the direction in which
 * x_j is about to move. The share starts at the root of the round-off and is adapted from one
 * Jacobian to the next: where the largest change of f is so small a part of f that round-off eats
 * it, the share grows, at once and with a second difference if nothing else is left of it; where
 * the change is large, the share shrinks for the sake of curvature. Salane, SAND86-1319, 1986. A
 * value that is not finite makes the column be differenced to the other side.
 */
final class JacobianDifferences {
  private static final double ROUNDOFF = Math.ulp(1.0);
  private static final double FIRST_SHARE = Math.sqrt(ROUNDOFF);

  /** Smallest share of what may be curved. */
  static final double SMALLEST_SHARE = power(0.78);

  private static final double LARGEST_SHARE = 0.1;

  /** Changes, relative to f: lost in round-off, poor, and too large for a straight line. */
  private static final double LOST = power(0.875);

  private static final double POOR = power(0.75);
  private static final double LARGE = power(0.25);

  /** Factor of a share after a poor change, its reciprocal after a large one. */
  private static final double ADAPTATION = 10;

  private final MatrixLayout layout;
  private final ColumnGroups groups;
  private final Manifold manifold;
  private final double[] threshold;

  /** Share of each column, the one for the next Jacobian, and the increment δ, length n. */
  private final double[] share;

  private final double[] nextShare;

  /** Below it no share shrinks. */
  private final double smallestShare;

  private final double[] increment;

  /** Increment of a column before it was differenced again, length n. */
  private final double[] firstIncrement;

  /** Whether the change in a column was lost in round-off, length n. */
  private final boolean[] lost;

  /** Looks at the columns formed, if anything does. */
  private Optional<ColumnTest> test = Optional.empty();

  /** Where to move and how large the terms are that f is the sum of, length n. */
  private double[] direction = {};

  private double timeDirection = 1;

  private double[] magnitude = {};

  /** Whether the shares are adapted: not as long as nothing is known of the terms' size. */
  private boolean adapting;

  /** f at the point, the point moved, and f there, length n. */
  private final double[] base;

  private final double[] moved;
  private final double[] movedValue;

  private boolean baseKnown;

  /** Whether a stop came between the first and the second evaluation for the group. */
  private boolean repeating;

  /** Group of columns to be differenced next. */
  private int group;

  private int notFiniteComponent;

  /**
   * For a function whose values are as large as the terms they are the sum of.
   *
   * @param threshold size below which a component is negligible; kept, not modified
   */
  JacobianDifferences(
      MatrixLayout layout, ColumnGroups groups, double[] threshold, Manifold manifold) {
    this(layout, groups, threshold, manifold, FIRST_SHARE, SMALLEST_SHARE);
    magnitude = new double[layout.dimension()];
    adapting = true;
  }

  /**
   * For a function whose values are small sums of large terms.
   *
   * @param threshold size below which a component is negligible; kept, not modified
   * @param firstShare share of a component to begin with
   * @param smallestShare share of a component at least: {@link #SMALLEST_SHARE}, or {@code
   *     firstShare} for a function that is a straight line or nearly so. A share that shrank while
   *     all terms were small would be lost in round-off where they are large at once.
   */
  JacobianDifferences(
      MatrixLayout layout,
      ColumnGroups groups,
      double[] threshold,
      Manifold manifold,
      double firstShare,
      double smallestShare) {
    int n = layout.dimension();
    this.layout = layout;
    this.groups = groups;
    this.manifold = manifold;
    this.threshold = threshold;
    this.smallestShare = smallestShare;
    share = new double[n];
    Arrays.fill(share, firstShare);
    nextShare = share.clone();
    increment = new double[n];
    firstIncrement = new double[n];
    lost = new boolean[n];
    base = new double[n];
    moved = new double[n];
    movedValue = new double[n];
  }

  private static double power(double exponent) {
    return StrictMath.pow(ROUNDOFF, exponent);
  }

  /** Tells f at the point at which the next Jacobian will be formed; not modified. */
  void knowValue(double[] value) {
    System.arraycopy(value, 0, base, 0, base.length);
    baseKnown = true;
    repeating = false;
    group = 0;
  }

  /** Returns how many evaluations a Jacobian takes, but for those of its point. */
  int evaluations() {
    return groups.count();
  }

  /** Forgets a Jacobian that was stopped half way. */
  void abandon() {
    baseKnown = false;
    repeating = false;
    group = 0;
    if (test.isPresent()) {
      test.get().abandon();
    }
  }

  /** Returns f at the point at which the Jacobian was formed; not to be modified. */
  double[] value() {
    return base;
  }

  /**
   * Tells how large the terms are that f is the sum of, for the Jacobians to come.
   *
   * @param magnitude kept, not modified
   */
  void knowMagnitude(double[] magnitude) {
    this.magnitude = magnitude;
    adapting = true;
  }

  /** Has the columns of the Jacobians to come looked at. */
  void testColumns(ColumnTest.Maker tests) {
    test = Optional.of(tests.of(layout, groups));
  }

  /** Returns what looks at the columns, if anything does. */
  Optional<ColumnTest> test() {
    return test;
  }

  /** Says which way time runs, 1 or -1, and with it where slopes lead. */
  void runTime(double forthOrBack) {
    timeDirection = forthOrBack;
  }

  /**
   * Forms the Jacobian; after {@link TrialOutcome#STOPPED} the next call goes on where this one
   * stopped.
   *
   * @param x the point; not modified
   * @param direction which way each component moves as time grows, by its sign; may be {@link
   *     #value}
   * @param jacobian overwritten
   */
  TrialOutcome evaluate(
      DifferencedFunction function, double[] x, double[] direction, double[] jacobian) {
    this.direction = direction;
    TrialOutcome attempt = continueEvaluation(function, x, jacobian);
    if (attempt != TrialOutcome.STOPPED) {
      baseKnown = false;
      group = 0;
      adoptShares();
    }
    return attempt;
  }

  private void adoptShares() {
    for (int j = 0; j < share.length; j++) {
      boolean kept = test.isPresent() && test.get().jumped(j);
      share[j] = kept ? share[j] : nextShare[j];
    }
  }

  private TrialOutcome continueEvaluation(
      DifferencedFunction function, double[] x, double[] jacobian) {
    if (!baseKnown) {
      if (!function.evaluate(x, base)) {
        return TrialOutcome.STOPPED;
      }
      if (!finite(base)) {
        return TrialOutcome.NOT_FINITE;
      }
      baseKnown = true;
    }
    System.arraycopy(x, 0, moved, 0, moved.length);
    for (; group < groups.count(); group++) {
      TrialOutcome attempt =
          differenced(group) ? differenceGroup(function, x, jacobian) : clearGroup(jacobian);
      if (attempt != TrialOutcome.PASSED) {
        return attempt;
      }
    }
    return test.isPresent()
        ? test.get().look(function, moved, base, increment, jacobian)
        : TrialOutcome.PASSED;
  }

  /** Returns whether the group has a column to be differenced. */
  private boolean differenced(int group) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (manifold.independent(j)) {
        return true;
      }
    }
    return false;
  }

  private TrialOutcome clearGroup(double[] jacobian) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      clearColumn(j, jacobian);
    }
    return TrialOutcome.PASSED;
  }

  private void clearColumn(int j, double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      jacobian[layout.index(i, j)] = 0;
    }
  }

  private TrialOutcome differenceGroup(
      DifferencedFunction function, double[] x, double[] jacobian) {
    if (repeating) {
      return repeatLost(function, x, jacobian);
    }
    moveGroup(x, 1);
    if (!function.evaluate(moved, movedValue)) {
      return TrialOutcome.STOPPED;
    }
    if (!finite(movedValue)) {
      moveGroup(x, -1);
      if (!function.evaluate(moved, movedValue)) {
        return TrialOutcome.STOPPED;
      }
      if (!finite(movedValue)) {
        return TrialOutcome.NOT_FINITE;
      }
    }
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      moved[j] = x[j];
      if (manifold.independent(j)) {
        double change = writeColumn(j, jacobian);
        lost[j] = judge(j, share[j], change);
      } else {
        clearColumn(j, jacobian);
        lost[j] = false;
      }
    }
    return repeatLost(function, x, jacobian);
  }

  /** Moves the columns of the group; after a stop the same way again. */
  private void moveGroup(double[] x, int sign) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (manifold.independent(j)) {
        move(j, x, sign, share[j]);
      }
    }
  }

  private void move(int j, double[] x, int sign, double withShare) {
    double way = timeDirection * direction[j] >= 0 ? sign : -sign;
    double size = withShare * Math.max(Math.abs(x[j]), threshold[j]);
    moved[j] = x[j] + way * size;
    increment[j] = moved[j] - x[j];
    if (increment[j] == 0) {
      moved[j] = x[j] + way * Math.max(Math.ulp(x[j]), threshold[j]);
      increment[j] = moved[j] - x[j];
    }
  }

  /** Writes the difference quotients of column j; returns the largest change of f. */
  private double writeColumn(int j, double[] jacobian) {
    double largest = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      double change = groups.couples(i, j) ? movedValue[i] - base[i] : 0;
      jacobian[layout.index(i, j)] = change / increment[j];
      largest = Math.max(largest, Math.abs(change));
    }
    return largest;
  }

  /** Adapts the share of column j; returns whether its change was lost in round-off. */
  private boolean judge(int j, double used, double change) {
    nextShare[j] = used;
    if (!adapting) {
      return false;
    }
    int row = rowOf(change, j);
    double here = Math.abs(base[row]);
    double there = Math.abs(movedValue[row]);
    double size = Math.max(magnitude[row], Math.max(here, there));
    boolean comparable = change == 0 || magnitude[row] != 0 || (here != 0 && there != 0);
    if (comparable && change <= POOR * size) {
      nextShare[j] = Math.min(LARGEST_SHARE, ADAPTATION * used);
    } else if (comparable && change > LARGE * size) {
      nextShare[j] = Math.max(smallestShare, used / ADAPTATION);
    }
    return comparable && change <= LOST * size;
  }

  private int rowOf(double change, int j) {
    int row = layout.firstRow(j);
    while (row < layout.lastRow(j)
        && !(groups.couples(row, j) && Math.abs(movedValue[row] - base[row]) == change)) {
      row = layout.nextRow(row, j);
    }
    return row;
  }

  /** Differences the columns of the group that were lost in round-off again, over more. */
  private TrialOutcome repeatLost(DifferencedFunction function, double[] x, double[] jacobian) {
    boolean anyLost = false;
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      double larger = largerShare(j);
      lost[j] &= larger != share[j];
      if (lost[j]) {
        firstIncrement[j] = repeating ? firstIncrement[j] : increment[j];
        move(j, x, 1, larger);
        anyLost = true;
      }
    }
    if (!anyLost) {
      return TrialOutcome.PASSED;
    }
    repeating = !function.evaluate(moved, movedValue);
    if (repeating) {
      return TrialOutcome.STOPPED;
    }
    boolean finite = finite(movedValue);
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (!lost[j]) {
        continue;
      }
      moved[j] = x[j];
      if (finite && largerShare(j) * steepestMoved(j) >= steepest(j, jacobian)) {
        judge(j, largerShare(j), writeColumn(j, jacobian));
      } else {
        increment[j] = firstIncrement[j];
      }
    }
    return TrialOutcome.PASSED;
  }

  private double largerShare(int j) {
    return Math.min(Math.sqrt(share[j]), LARGEST_SHARE);
  }

  private double steepest(int j, double[] jacobian) {
    double slope = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      slope = Math.max(slope, Math.abs(jacobian[layout.index(i, j)]));
    }
    return slope;
  }

  private double steepestMoved(int j) {
    double change = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      if (groups.couples(i, j)) {
        change = Math.max(change, Math.abs(movedValue[i] - base[i]));
      }
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

  /** Carries over how far to move, and the value at the next point if that is known. */
  void transfer(SavedState state) {
    state.numbers(share);
    state.numbers(nextShare);
    state.numbers(base);
    test.ifPresent(columns -> columns.transfer(state));
    baseKnown = state.flag(baseKnown);
  }
}
