package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeEvaluation;

/**
 * The point of a curve z = h(x) that is closest to a point (x, z), and the frame of the curve
 * there. Legend: s its abscissa; θ the angle of slope, tan θ = h′(s); n = (−sin θ, cos θ) the
 * normal; σ the distance along n, positive above the curve.
 *
 * <p>s is the root of g(s) = s − x + (h(s) − z) h′(s). {@value #STEPS} steps of Newton's method
 * lead to it from the point below, s = x; generated code takes the same steps. A straight line
 * needs one. Above the curve σ is at least the way to the point at s, wherever the steps have led:
 * a search that went astray finds no contact where there is none.
 */
public final class ClosestPoint {
  /** Steps of Newton's method. */
  public static final int STEPS = 5;

  /** Largest last step of a search that has converged, relative to the radius and the way to s. */
  public static final double CONVERGED = 1e-6;

  /** Least share of 1 + h′² that divides a step: far above a hollow Newton's own may be zero. */
  public static final double LEAST = 0.25;

  private final TapeEvaluation height;

  /** Leaf that is the abscissa; −1 of a horizontal line. */
  private final int argument;

  private double value;
  private double slope;
  private double bend;
  private double distance;
  private double sine;
  private double cosine;
  private double turning;
  private boolean found;

  ClosestPoint(Expression curve) {
    height = new TapeEvaluation(new Tape(List.of(curve)));
    argument = leaves().indexOf(new Argument());
  }

  /** Returns what the curve depends on. */
  List<Expression> leaves() {
    return height.tape().leaves();
  }

  void parameters(double[] values) {
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
   * @param radius of the sphere around (x, z), m
   * @return whether height, slope and bend are finite
   */
  boolean find(double x, double z, double radius) {
    evaluate(x);
    double below = value;
    double top = value + radius * Math.sqrt(1 + slope * slope) + radius;
    double s = x;
    double step = 0;
    for (int i = 0; i < STEPS && argument >= 0; i++) {
      double g = s - x + (value - z) * slope;
      double square = 1 + slope * slope;
      step = g / Math.max(square + (value - z) * bend, LEAST * square);
      s -= step;
      evaluate(s);
    }
    double root = Math.sqrt(1 + slope * slope);
    cosine = 1 / root;
    sine = slope / root;
    double way = x - s;
    double up = z - value;
    distance = (up - slope * way) / root;
    if (z > below) {
      distance = Math.max(distance, Math.sqrt(way * way + up * up));
    }
    double curvature = bend / (root * root * root);
    turning = curvature / (1 - curvature * distance);
    found = z >= top || Math.abs(step) <= CONVERGED * (radius + Math.abs(way) + Math.abs(up));
    return Double.isFinite(distance + bend);
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

  /**
   * Returns whether the search converged; also true where the sphere is more than its radius above
   * a touch.
   */
  boolean isFound() {
    return found;
  }

  /** Returns σ, m. */
  double distance() {
    return distance;
  }

  /** Returns sin θ. */
  double sine() {
    return sine;
  }

  /** Returns cos θ. */
  double cosine() {
    return cosine;
  }

  /** Returns dθ by the displacement of the point along the curve, 1/m. */
  double turning() {
    return turning;
  }
}
