package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.spatial.CubicCurve;

/**
 * The search for the point of a curve z = h(x) that is closest to a point (x, z). Legend: s its
 * abscissa; g(s) = s − x + (h(s) − z) h′(s) half of the derivative of the squared distance. {@link
 * ClosestFoot} has the distance and the normal there.
 *
 * <p>The point is sought between x − w and x + w, with w = |h(x) − z|. On a table {@link
 * CubicCurve#closest} finds it, piece for piece. On any other height the closest of {@value #SEEDS}
 * places to each side of x is taken, and g = 0 is solved between its neighbours, by Newton's method
 * with an interval that shrinks, by half or to where the tangents at its ends meet, a corner; what
 * is narrower than a {@value #SEEDS}th of the window can be missed. Generated code takes the same
 * steps. Of two points at the same distance either is taken; the distance is continuous there, the
 * normal jumps.
 */
public final class ClosestPoint {
  /** Places to each side of x. */
  public static final int SEEDS = 8;

  /** Largest number of steps of Newton's method; halvings would leave 2⁻¹² of an interval. */
  public static final int STEPS = 12;

  private final FormulaEvaluation height;

  /** The curve as a row of {@link CubicCurve}; empty if it is not a table of the abscissa. */
  private final double[] row;

  /** Leaf that is the abscissa; −1 of a horizontal line. */
  private final int argument;

  private double below;
  private double station;
  private double value;
  private double slope;
  private double bend;

  public ClosestPoint(Expression curve) {
    height = new FormulaEvaluation(List.of(curve));
    argument = leaves().indexOf(new Argument());
    row = row(curve).orElse(new double[0]);
  }

  /** Returns a table of the abscissa as a row of {@link CubicCurve}; empty for other curves. */
  public static Optional<double[]> row(Expression curve) {
    return curve instanceof TableValue value
            && value.table() instanceof Table table
            && value.arguments().get(0) instanceof Argument
        ? Optional.of(table.curve().row())
        : Optional.empty();
  }

  /** Returns what the curve depends on. */
  public List<Expression> leaves() {
    return height.leaves();
  }

  public void parameters(double[] values) {
    List<Expression> leaves = leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof ParameterValue parameter) {
        height.setLeaf(i, values[parameter.index()], 0, 0);
      }
    }
  }

  /**
   * Finds the closest point.
   *
   * @return whether height, slope and bend are finite
   */
  public boolean find(double x, double z) {
    evaluate(x);
    below = value;
    double s = x;
    if (row.length > 0) {
      s = CubicCurve.closest(row, 0, row.length, x, z);
      evaluate(s);
    } else if (argument >= 0) {
      s = search(x, z);
    }
    station = s;
    return Double.isFinite(value + slope + bend);
  }

  /** Finds s and evaluates the curve there. */
  private double search(double x, double z) {
    double above = Math.abs(value - z);
    double part = above / SEEDS;
    double s = x;
    double least = above * above;
    for (int i = 1; i <= SEEDS; i++) {
      for (int side = -1; side <= 1; side += 2) {
        double place = x + side * i * part;
        evaluate(place);
        double square = (place - x) * (place - x) + (value - z) * (value - z);
        if (square <= least) {
          least = square;
          s = place;
        }
      }
    }
    double low = s - part;
    double high = s + part;
    evaluate(low);
    double lowSlope = slope;
    double lowHeight = value - slope * low;
    evaluate(high);
    double highSlope = slope;
    double highHeight = value - slope * high;
    evaluate(s);
    for (int i = 0; i < STEPS; i++) {
      double g = s - x + (value - z) * slope;
      double rise = 1 + slope * slope + (value - z) * bend;
      double height = value - slope * s;
      if (g <= 0) {
        low = s;
        lowSlope = slope;
        lowHeight = height;
      } else {
        high = s;
        highSlope = slope;
        highHeight = height;
      }
      double next = s - g / rise;
      if (!(rise > 0 && next >= low && next <= high)) {
        double corner = (highHeight - lowHeight) / (lowSlope - highSlope);
        boolean between = i % 2 == 1 && corner >= low && corner <= high;
        next = between ? corner : 0.5 * (low + high);
      }
      if (next == s) {
        break;
      }
      s = next;
      evaluate(s);
    }
    return s;
  }

  private void evaluate(double s) {
    if (argument >= 0) {
      height.setLeaf(argument, s, 1, 0);
    }
    height.derivatives();
    height.rates();
    value = height.value(0);
    slope = height.rate(0);
    bend = height.secondRate(0);
  }

  /** Returns s, m. */
  public double station() {
    return station;
  }

  /**
   * Writes the curve at the closest point: s, h(s), m, h′(s), h″(s), 1/m, and h(x), m.
   *
   * @param out overwritten from {@code at}
   */
  public void curve(double[] out, int at) {
    out[at] = station;
    out[at + 1] = value;
    out[at + 2] = slope;
    out[at + 3] = bend;
    out[at + 4] = below;
  }
}
