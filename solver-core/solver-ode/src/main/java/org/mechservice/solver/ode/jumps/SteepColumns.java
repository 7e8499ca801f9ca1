package org.mechservice.solver.ode.jumps;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.newton.ColumnGroups;
import org.mechservice.solver.ode.newton.ColumnTest;
import org.mechservice.solver.ode.newton.DifferencedFunction;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Tells slopes from jumps in the columns of a Jacobian by differences.
 *
 * <p>A jump of f within the increment δ looks like a slope, the steeper the smaller δ is. An
 * iteration that believes it finds every change negligible, whatever is left of the equations, and
 * lets the solution slide along its own prediction. So a column that is suddenly much steeper than
 * before is differenced again over ever smaller parts of δ. What a slope changes falls with the
 * increment; then the one over the smallest part is right, which has no jump within. What a jump
 * changes stays; then the jump lies within that part, and the slope is the one behind it. Columns
 * that share no row are looked at together, with one evaluation for all of them.
 */
final class SteepColumns implements ColumnTest {
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

  /** The same of the Jacobian looked at, length n. */
  private final double[] slopes;

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

  /** Group of columns to be looked at next, and the parts of it that were; 0 before it is begun. */
  private int group;

  private int parts;

  /** Whether the change in a column over the last of them was as large as the whole, length n. */
  private final boolean[] staying;

  /** How long the last part was that was looked at; 0 in columns that are not steep, length n. */
  private final double[] reached;

  /** Where a column was before it was moved, and how far it was, length n. */
  private final double[] here;

  private final double[] way;

  SteepColumns(MatrixLayout layout, ColumnGroups groups) {
    int n = layout.dimension();
    this.layout = layout;
    this.groups = groups;
    known = new double[n];
    slopes = new double[n];
    terms = new double[n];
    noticed = new double[n];
    value = new double[n];
    whole = new double[n];
    part = new double[n];
    jumped = new boolean[n];
    staying = new boolean[n];
    reached = new double[n];
    here = new double[n];
    way = new double[n];
  }

  @Override
  public void expect(double factor, double[] slopes) {
    sure = slopes;
    sureFactor = factor;
  }

  @Override
  public double[] terms() {
    return terms;
  }

  @Override
  public void abandon() {
    group = 0;
    parts = 0;
  }

  @Override
  public TrialOutcome look(
      DifferencedFunction function,
      double[] x,
      double[] base,
      double[] increment,
      double[] jacobian) {
    if (group == 0 && parts == 0) {
      Arrays.fill(jumped, false);
      if (allAsBefore(jacobian)) {
        return TrialOutcome.PASSED;
      }
      noticeFrom(x, base, increment, jacobian);
    }
    for (; group < groups.count(); group++) {
      if (!lookAtGroup(function, x, base, increment, jacobian)) {
        return TrialOutcome.STOPPED;
      }
    }
    group = 0;
    for (int j = 0; j < known.length; j++) {
      known[j] = steepest(j, jacobian);
    }
    return TrialOutcome.PASSED;
  }

  /**
   * Returns whether no column is much steeper than before; what is known of them is renewed then.
   */
  private boolean allAsBefore(double[] jacobian) {
    for (int j = 0; j < known.length; j++) {
      slopes[j] = steepest(j, jacobian);
      if (!(slopes[j] <= believable(j))) {
        return false;
      }
    }
    System.arraycopy(slopes, 0, known, 0, known.length);
    return true;
  }

  @Override
  public boolean jumped(int j) {
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
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
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
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      slope = Math.max(slope, Math.abs(unsure(i, j, jacobian)));
    }
    return slope;
  }

  /** Returns whether column j may have a jump instead of a slope. */
  private boolean steep(int j, double increment, double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      double slope = Math.abs(unsure(i, j, jacobian));
      if (slope > believable(j) && slope * Math.abs(increment) > noticed[i]) {
        return true;
      }
    }
    return false;
  }

  /** Differences the steep columns of the group again; returns false if told to stop instead. */
  private boolean lookAtGroup(
      DifferencedFunction function,
      double[] x,
      double[] base,
      double[] increment,
      double[] jacobian) {
    if (parts == 0) {
      beginGroup(increment, jacobian);
    }
    for (; parts < PARTS && move(x, increment); parts++) {
      boolean going = function.evaluate(x, value);
      putBack(x);
      if (!going) {
        return false;
      }
      if (RightHandSide.firstNotFinite(value) >= 0) {
        break;
      }
      takeChanges(base);
    }
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (reached[j] != 0) {
        correct(j, increment[j], reached[j], jacobian);
      }
    }
    parts = 0;
    return true;
  }

  private void beginGroup(double[] increment, double[] jacobian) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      reached[j] = 0;
      staying[j] = steep(j, increment[j], jacobian);
      for (int i = layout.firstRow(j);
          staying[j] && i <= layout.lastRow(j);
          i = layout.nextRow(i, j)) {
        if (groups.couples(i, j)) {
          whole[i] = unsure(i, j, jacobian) * increment[j];
        }
      }
    }
  }

  /** Moves the columns whose change stays by the next part; returns whether there are any. */
  private boolean move(double[] x, double[] increment) {
    boolean moved = false;
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (staying[j]) {
        here[j] = x[j];
        x[j] += StrictMath.scalb(increment[j], LOG_OF_PART * (parts + 1));
        way[j] = x[j] - here[j];
        staying[j] = way[j] != 0;
        moved |= staying[j];
      }
    }
    return moved;
  }

  private void putBack(double[] x) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (staying[j]) {
        x[j] = here[j];
      }
    }
  }

  private void takeChanges(double[] base) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      if (staying[j]) {
        reached[j] = way[j];
        staying[j] = takeChange(j, base, way[j]);
      }
    }
  }

  /** Takes the change over the part; returns whether it is about as large as the whole. */
  private boolean takeChange(int j, double[] base, double way) {
    boolean stays = false;
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      if (groups.couples(i, j)) {
        part[i] = value[i] - base[i] - sure(layout.index(i, j)) * way;
        stays |= Math.abs(whole[i]) > noticed[i] && stays(i);
      }
    }
    return stays;
  }

  private boolean stays(int i) {
    return Math.abs(part[i]) > STAYS * Math.abs(whole[i]);
  }

  private void correct(int j, double increment, double way, double[] jacobian) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      if (!groups.couples(i, j) || !(Math.abs(whole[i]) > noticed[i])) {
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

  @Override
  public void transfer(SavedState state) {
    state.numbers(known);
  }
}
