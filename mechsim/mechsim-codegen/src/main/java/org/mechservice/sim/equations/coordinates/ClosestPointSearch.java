package org.mechservice.sim.equations.coordinates;

import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.force.law.ClosestFoot;
import org.mechservice.solver.force.law.ClosestPoint;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.Substitution;

/**
 * The search for the point of a curve that is closest to another, in the steps of {@link
 * ClosestPoint}.
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
  public record Curve(Scalar way, Scalar height, Scalar slope, Scalar bend, Optional<NumberRow> row)
      implements ClosestFoot.Curve {
    /** Returns the curve of a height of {@link Expression.Argument} and parameters. */
    public static Curve of(Expressions expressions, Expression height) {
      Scalar way = expressions.input(Program.PLACEHOLDER);
      Differentiation byWay = new Differentiation(expressions, Map.of(way, expressions.one()));
      Scalar h = new OfArgument(expressions, way).scalar(height);
      Scalar slope = byWay.of(h);
      return new Curve(
          way, h, slope, byWay.of(slope), ClosestPoint.row(height).map(NumberRow::new));
    }

    @Override
    public Curve moved(Scalar by) {
      return at(way.plus(by));
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

  private ClosestPointSearch() {}

  /**
   * Returns the closest point of a curve.
   *
   * @param ofCentre whether the curve is that of the sphere's centre, else the surface
   */
  public static ClosestFoot foot(Curve curve, Scalar x, Scalar z, boolean ofCentre) {
    boolean isStraight = curve.bend().isZero() && curve.slope() == curve.at(x).slope();
    return isStraight
        ? new ClosestFoot(curve.at(x), x, z, ofCentre)
        : new ClosestFoot(curve.at(station(curve, x, z)), curve.at(x).height(), x, z, ofCentre);
  }

  /** Returns the abscissa of the closest point, without derivatives. */
  static Scalar station(Curve curve, Scalar x, Scalar z) {
    Expressions e = x.expressions();
    return curve.row().map(row -> e.closest(row, x, z)).orElseGet(() -> searched(curve, x, z));
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
      Scalar g = ClosestFoot.g(at, x, z);
      Scalar rise = ClosestFoot.rise(at, z);
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
