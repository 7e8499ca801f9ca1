package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Tells slopes from jumps in the columns of a Jacobian by differences.
 *
 * <p>A jump of f within the increment δ looks like a slope, the steeper the smaller δ is. An
 * iteration that believes it finds every change negligible, whatever is left of the equations, and
 * lets the solution slide along its own prediction. So a column that is suddenly much steeper than
 * before is differenced again over ever smaller parts of δ. What a slope changes falls with the
 * increment; then the one over the smallest part is right, which has no jump within. What a jump
 * changes stays; then the jump lies within that part, and the slope is the one behind it.
 */
final class JacobianJumpTest {
  /** How much steeper than before is suspicious. */
  private static final double MUCH_STEEPER = 100;

  /** Change of f, relative to it, that is large for so small an increment. */
  private static final double LARGE = StrictMath.pow(Math.ulp(1.0), 0.25);

  /** Binary logarithm of the part of the increment that is looked at next. */
  private static final int LOG_OF_PART = -10;

  /** Parts of parts: below the last, no number lies between an increment and 0. */
  private static final int PARTS = 3;

  /** A change this many times the rounding errors of f has some of its digits left over a part. */
  private static final double ABOVE_ROUND_OFF = 0x1p16 * Math.ulp(1.0);

  /** Part of the change that does not fall with the increment. */
  private static final double STAYS = 0x1p-4;

  /** How much two slopes may differ, relative to each other, for the sake of curvature. */
  private static final double CURVED = 0.5;

  private final MatrixLayout layout;
  private final ColumnGroups groups;

  /** Steepest slope of each column when the Jacobian was formed last, length n. */
  private final double[] known;

  /** Slopes by layout, and their factor, that are known to be in the Jacobian: they do not jump. */
  private double[] sure = {};

  private double sureFactor;

  /** Size of the terms of f that do not depend on x, length n; 0 if it has none. */
  private final double[] terms;

  /** Change of f, by rows, that is large and is not made of rounding errors, length n. */
  private final double[] noticed;

  /** f beyond the part, the whole change of f and that over the part, length n. */
  private final double[] value;

  private final double[] whole;
  private final double[] part;

  /** Whether there was a jump in a column of the last Jacobian, length n. */
  private final boolean[] jumped;

  private boolean watching;

  /** Column to be looked at next, and the parts of it that were. */
  private int column;

  private int parts;

  /** Whether the change over the last of them was as large as the whole, and how long that was. */
  private boolean stays = true;

  private double reached;

  JacobianJumpTest(MatrixLayout layout, ColumnGroups groups) {
    int n = layout.dimension();
    this.layout = layout;
    this.groups = groups;
    known = new double[n];
    terms = new double[n];
    noticed = new double[n];
    value = new double[n];
    whole = new double[n];
    part = new double[n];
    jumped = new boolean[n];
  }

  /** Sets whether steep columns are looked at again. */
  void watch(boolean watching) {
    this.watching = watching;
  }

  /**
   * Tells a part of the next Jacobian that is known.
   *
   * @param slopes by layout; kept, not modified
   */
  void expect(double factor, double[] slopes) {
    sure = slopes;
    sureFactor = factor;
  }

  /** Returns where to write the size of the terms of f that do not depend on x. */
  double[] terms() {
    return terms;
  }

  /** Forgets a Jacobian that was stopped half way. */
  void abandon() {
    column = 0;
    beginColumn();
  }

  /**
   * Looks at the steep columns of a Jacobian; after {@link TrialOutcome#STOPPED} the next call goes
   * on where this one stopped.
   *
   * @param x the point; moved, and put back
   * @param base f there
   * @param increment over which each column was differenced
   * @param jacobian overwritten where it was no slope at the point
   * @return {@link TrialOutcome#STOPPED} or {@link TrialOutcome#PASSED}
   */
  TrialOutcome look(
      DifferencedFunction function,
      double[] x,
      double[] base,
      double[] increment,
      double[] jacobian) {
    if (!watching) {
      return TrialOutcome.PASSED;
    }
    if (column == 0) {
      noticeFrom(x, base, increment, jacobian);
      Arrays.fill(jumped, false);
    }
    for (; column < known.length; column++) {
      if (steep(column, increment[column], jacobian)
          && !lookAt(column, function, x, base, increment[column], jacobian)) {
        return TrialOutcome.STOPPED;
      }
    }
    column = 0;
    for (int j = 0; j < known.length; j++) {
      known[j] = steepest(j, jacobian);
    }
    return TrialOutcome.PASSED;
  }

  /** Returns whether there was a jump in column j of the last Jacobian. */
  boolean jumped(int j) {
    return jumped[j];
  }

  /**
   * What is small beside f, beside its change in another column, or beside rounding errors is not
   * noticed.
   */
  private void noticeFrom(double[] x, double[] base, double[] increment, double[] jacobian) {
    for (int i = 0; i < noticed.length; i++) {
      double size = Math.abs(base[i]) + terms[i];
      whole[i] = size;
      noticed[i] = size;
    }
    for (int j = 0; j < x.length; j++) {
      double most = known[j] > 0 ? believable(j) : Double.POSITIVE_INFINITY;
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        double slope = Math.abs(jacobian[layout.index(i, j)]);
        whole[i] += Math.min(slope, most) * Math.abs(x[j]);
        noticed[i] = Math.max(noticed[i], slope * Math.abs(increment[j]));
      }
    }
    for (int i = 0; i < noticed.length; i++) {
      noticed[i] = Math.max(LARGE * noticed[i], ABOVE_ROUND_OFF * whole[i]);
    }
  }

  private double believable(int j) {
    return MUCH_STEEPER * known[j];
  }

  private double unsure(int i, int j, double[] jacobian) {
    int at = layout.index(i, j);
    return jacobian[at] - sure(at);
  }

  private double sure(int at) {
    return sureFactor == 0 ? 0 : sureFactor * sure[at];
  }

  private double steepest(int j, double[] jacobian) {
    double slope = 0;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      slope = Math.max(slope, Math.abs(unsure(i, j, jacobian)));
    }
    return slope;
  }

  /** Returns whether column j may have a jump instead of a slope. */
  private boolean steep(int j, double increment, double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      double slope = Math.abs(unsure(i, j, jacobian));
      if (slope > believable(j) && slope * Math.abs(increment) > noticed[i]) {
        return true;
      }
    }
    return false;
  }

  /** Differences column j again; returns false if told to stop instead. */
  private boolean lookAt(
      int j,
      DifferencedFunction function,
      double[] x,
      double[] base,
      double increment,
      double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      whole[i] = unsure(i, j, jacobian) * increment;
    }
    for (; stays && parts < PARTS; parts++) {
      double here = x[j];
      x[j] = here + StrictMath.scalb(increment, LOG_OF_PART * (parts + 1));
      double moved = x[j] - here;
      boolean going = moved == 0 || function.evaluate(x, value);
      x[j] = here;
      if (!going) {
        return false;
      }
      if (moved == 0 || RightHandSide.firstNotFinite(value) >= 0) {
        break;
      }
      reached = moved;
      stays = takeChange(j, base, moved);
    }
    if (reached != 0) {
      correct(j, increment, reached, jacobian);
    }
    beginColumn();
    return true;
  }

  private void beginColumn() {
    parts = 0;
    stays = true;
    reached = 0;
  }

  /** Takes the change over the part; returns whether it is about as large as the whole. */
  private boolean takeChange(int j, double[] base, double way) {
    boolean stays = false;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      double change = groups.couples(i, j) ? value[i] - base[i] : 0;
      part[i] = change - sure(layout.index(i, j)) * way;
      stays |= Math.abs(whole[i]) > noticed[i] && stays(i);
    }
    return stays;
  }

  private boolean stays(int i) {
    return Math.abs(part[i]) > STAYS * Math.abs(whole[i]);
  }

  private void correct(int j, double increment, double way, double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
      if (!(Math.abs(whole[i]) > noticed[i])) {
        continue;
      }
      int at = layout.index(i, j);
      double slope = part[i] / way;
      if (stays(i)) {
        jumped[j] = true;
        jacobian[at] = sure(at) + (whole[i] - part[i]) / (increment - way);
      } else if (Math.abs(slope * increment - whole[i]) > CURVED * Math.abs(whole[i])) {
        jacobian[at] = sure(at) + slope;
      }
    }
  }

  /** Carries over the slopes known. */
  void transfer(SavedState state) {
    state.numbers(known);
  }
}
