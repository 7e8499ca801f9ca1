package org.mechservice.sim.equations.coordinates;

import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.force.law.ClosestPoint;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.Substitution;

/**
 * The point of a curve z = h(x) that is closest to a point (x, z), by the steps of {@link
 * ClosestPoint}: distance along the normal (−sin θ, cos θ), and θ.
 */
public final class ClosestPointSearch {
  /**
   * A curve.
   *
   * @param way its argument
   * @param height h of it
   * @param slope h′
   * @param bend h″
   * @param row the curve of a table
   */
  public record Curve(
      Scalar way, Scalar height, Scalar slope, Scalar bend, Optional<NumberRow> row) {
    /** Returns the curve of a height of {@link Expression.Argument} and parameters. */
    public static Curve of(Expressions expressions, Expression height) {
      Scalar way = expressions.input(Program.PLACEHOLDER);
      Differentiation byWay = new Differentiation(expressions, Map.of(way, expressions.one()));
      Scalar h = new OfArgument(expressions, way).scalar(height);
      Scalar slope = byWay.of(h);
      return new Curve(
          way, h, slope, byWay.of(slope), ClosestPoint.row(height).map(NumberRow::new));
    }

    private Curve at(Scalar s) {
      Substitution place = new Substitution(way, s);
      return new Curve(s, place.of(height), place.of(slope), place.of(bend), row);
    }
  }

  /** Formulas of the argument, whose place {@code way} holds. */
  private static final class OfArgument extends Formulas {
    private final Scalar way;

    OfArgument(Expressions expressions, Scalar way) {
      super(expressions);
      this.way = way;
    }

    @Override
    protected Scalar leaf(Expression leaf) {
      if (leaf instanceof Expression.Argument) {
        return way;
      }
      throw new IllegalArgumentException("a profile depends on " + leaf);
    }
  }

  /** Divides a step where s does not move. */
  private static final double FAR = 1e300;

  private final Expressions e;

  /** σ, m. */
  public final Scalar distance;

  public final Scalar sine;
  public final Scalar cosine;

  /** Whether the curve has corners: it is the surface, not that of the centre. */
  private final boolean corners;

  /**
   * @param ofCentre whether the curve is that of the sphere's centre, else the surface
   */
  public ClosestPointSearch(Curve curve, Scalar x, Scalar z, boolean ofCentre) {
    e = x.expressions();
    corners = !ofCentre;
    if (curve.bend().isZero() && curve.slope() == curve.at(x).slope()) {
      Curve at = curve.at(foot(curve.at(x), x, z));
      Scalar root = root(at);
      distance = along(at, x, z);
      sine = at.slope().over(root);
      cosine = e.one().over(root);
      return;
    }
    Scalar s = station(curve, x, z);
    Curve near = curve.at(s);
    Scalar g = g(near, x, z);
    Scalar full = rise(near, z);
    Scalar least = e.one().plus(near.slope().squared()).times(ClosestPoint.LEAST);
    Scalar rise = pick(full, least, least, full);
    Scalar size = held(e.function(MathFunction.ABS, g));
    Scalar limit = held(limit(near, x, z));
    Scalar moves = corners ? pick(size, limit, rise, e.constant(FAR)) : rise;
    // the step has no length; its derivative is that of s
    Curve at = curve.at(s.minus(g.minus(held(g)).over(moves)));
    Scalar root = root(at);
    Scalar along = along(at, x, z);
    Scalar level = e.one().over(root);
    Scalar slant = at.slope().over(root);
    if (!corners) {
      distance = along;
      sine = slant;
      cosine = level;
      return;
    }
    // choices between what is equal where they change are no switches
    Scalar direct = direct(at, x, z);
    Scalar side =
        e.function(
            MathFunction.CHOOSE, held(z), held(curve.at(x).height()), direct.negated(), direct);
    Scalar towards = at.way().minus(x).over(side);
    Scalar up = z.minus(at.height()).over(side);
    distance = e.function(MathFunction.CHOOSE, size, limit, along, side);
    sine = e.function(MathFunction.CHOOSE, size, limit, slant, towards);
    cosine = e.function(MathFunction.CHOOSE, size, limit, level, up);
  }

  /** Returns the abscissa of the closest point, without derivatives. */
  static Scalar station(Curve curve, Scalar x, Scalar z) {
    Expressions e = x.expressions();
    return curve.row().map(row -> e.closest(row, x, z)).orElseGet(() -> searched(curve, x, z));
  }

  /** Returns the largest |g| of a foot of a perpendicular. */
  private Scalar limit(Curve at, Scalar x, Scalar z) {
    Scalar size = e.function(MathFunction.ABS, x).plus(e.function(MathFunction.ABS, z));
    return root(at)
        .times(direct(at, x, z).times(ClosestPoint.CORNER).plus(size.times(ClosestPoint.ROUNDING)));
  }

  private Scalar root(Curve at) {
    return e.one().plus(at.slope().squared()).squareRoot();
  }

  private Scalar direct(Curve at, Scalar x, Scalar z) {
    return x.minus(at.way()).squared().plus(z.minus(at.height()).squared()).squareRoot();
  }

  private Scalar along(Curve at, Scalar x, Scalar z) {
    return z.minus(at.height()).minus(at.slope().times(x.minus(at.way()))).over(root(at));
  }

  private static Scalar g(Curve at, Scalar x, Scalar z) {
    return at.way().minus(x).plus(at.height().minus(z).times(at.slope()));
  }

  /** Returns g′. */
  private static Scalar rise(Curve at, Scalar z) {
    return z.expressions()
        .one()
        .plus(at.slope().squared())
        .plus(at.height().minus(z).times(at.bend()));
  }

  /** Returns s on a straight line, by one step of Newton's method from any place. */
  private Scalar foot(Curve at, Scalar x, Scalar z) {
    return at.way().minus(g(at, x, z).over(e.one().plus(at.slope().squared())));
  }

  private Scalar held(Scalar value) {
    return e.function(MathFunction.HELD, value);
  }

  private static Scalar searched(Curve curve, Scalar x, Scalar z) {
    Expressions e = x.expressions();
    Scalar above = e.function(MathFunction.ABS, curve.at(x).height().minus(z));
    Scalar part = above.over(e.constant(ClosestPoint.SEEDS));
    Scalar s = x;
    Scalar least = above.squared();
    for (int i = 1; i <= ClosestPoint.SEEDS; i++) {
      for (int side = -1; side <= 1; side += 2) {
        Scalar place = x.plus(part.times(side * i));
        Scalar up = curve.at(place).height().minus(z);
        Scalar square = place.minus(x).squared().plus(up.squared());
        s = pick(square, least, place, s);
        least = pick(square, least, square, least);
      }
    }
    Scalar low = s.minus(part);
    Scalar high = s.plus(part);
    Scalar lowSlope = curve.at(low).slope();
    Scalar lowHeight = curve.at(low).height().minus(lowSlope.times(low));
    Scalar highSlope = curve.at(high).slope();
    Scalar highHeight = curve.at(high).height().minus(highSlope.times(high));
    for (int i = 0; i < ClosestPoint.STEPS; i++) {
      Curve at = curve.at(s);
      Scalar g = g(at, x, z);
      Scalar rise = rise(at, z);
      Scalar height = at.height().minus(at.slope().times(s));
      low = pick(g, e.zero(), s, low);
      lowSlope = pick(g, e.zero(), at.slope(), lowSlope);
      lowHeight = pick(g, e.zero(), height, lowHeight);
      high = pick(g, e.zero(), high, s);
      highSlope = pick(g, e.zero(), highSlope, at.slope());
      highHeight = pick(g, e.zero(), highHeight, height);
      Scalar other = low.plus(high).times(0.5);
      if (i % 2 == 1) {
        Scalar corner = highHeight.minus(lowHeight).over(lowSlope.minus(highSlope));
        other = between(low, corner, high, other);
      }
      Scalar next = between(low, s.minus(g.over(rise)), high, other);
      s = pick(rise, e.zero(), other, next);
    }
    return s;
  }

  /** Returns a number if it is between two others, else another. */
  private static Scalar between(Scalar low, Scalar value, Scalar high, Scalar other) {
    return pick(low, value, pick(value, high, value, other), other);
  }

  private static Scalar pick(Scalar a, Scalar b, Scalar first, Scalar second) {
    return a.expressions().function(MathFunction.PICK, a, b, first, second);
  }
}
