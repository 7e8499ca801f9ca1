package org.mechservice.sim.equations.force;

import java.util.Optional;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.MathFunction;
import org.mechservice.sim.symbolic.NumberRow;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.Substitution;
import org.mechservice.solver.force.law.ClosestPoint;

/**
 * The point of a curve z = h(x) that is closest to a point (x, z), by the steps of {@link
 * ClosestPoint}: distance along the normal (−sin θ, cos θ), and θ.
 */
final class ClosestPointSearch {
  /**
   * A curve.
   *
   * @param way its argument
   * @param height h of it
   * @param slope h′
   * @param bend h″
   * @param row the curve of a table
   */
  record Curve(Scalar way, Scalar height, Scalar slope, Scalar bend, Optional<NumberRow> row) {
    private Curve at(Scalar s) {
      Substitution place = new Substitution(way, s);
      return new Curve(s, place.of(height), place.of(slope), place.of(bend), row);
    }
  }

  /** More than twice any distance, m. */
  private static final double FAR = 1e300;

  private final Expressions e;

  /** σ, m. */
  final Scalar distance;

  final Scalar sine;
  final Scalar cosine;

  /**
   * @param radius of the sphere, m
   * @param ofCentre whether the curve is that of the sphere's centre, else the surface
   */
  ClosestPointSearch(Curve curve, Scalar x, Scalar z, Scalar radius, boolean ofCentre) {
    e = x.expressions();
    boolean straight = curve.bend().isZero() && curve.row().isEmpty();
    Curve at = curve.at(straight ? foot(curve.at(x), x, z) : found(curve, x, z));
    Scalar root = e.one().plus(at.slope().squared()).squareRoot();
    Scalar way = x.minus(at.way());
    Scalar up = z.minus(at.height());
    Scalar along = up.minus(at.slope().times(way)).over(root);
    if (straight) {
      distance = along;
      cosine = e.one().over(root);
      sine = at.slope().over(root);
      return;
    }
    Scalar direct = way.squared().plus(up.squared()).squareRoot();
    // the larger in size; at a foot of a perpendicular both are the same, and no choice is a switch
    Scalar below = larger(direct, along.negated(), direct.negated(), along);
    Scalar above = larger(direct, along, direct, along);
    distance = e.function(MathFunction.CHOOSE, z, curve.at(x).height(), below, above);
    if (ofCentre || radius.isZero()) {
      cosine = e.one().over(root);
      sine = at.slope().over(root);
    } else {
      Scalar twice = direct.times(2);
      Scalar least = pick(radius, e.zero(), e.constant(FAR), radius);
      Scalar level = e.one().over(root);
      Scalar rise = at.slope().over(root);
      cosine = e.function(MathFunction.CHOOSE, least, twice, up.over(distance), level);
      Scalar towards = way.negated().over(distance);
      sine = e.function(MathFunction.CHOOSE, least, twice, towards, rise);
    }
  }

  /** Returns s on a straight line, by one step of Newton's method from any place. */
  private Scalar foot(Curve at, Scalar x, Scalar z) {
    Scalar g = at.way().minus(x).plus(at.height().minus(z).times(at.slope()));
    return at.way().minus(g.over(e.one().plus(at.slope().squared())));
  }

  /** Returns s, with the derivatives of the root of g. */
  private Scalar found(Curve curve, Scalar x, Scalar z) {
    Scalar s = curve.row().map(row -> e.closest(row, x, z)).orElseGet(() -> searched(curve, x, z));
    Curve at = curve.at(s);
    Scalar g = s.minus(x).plus(at.height().minus(z).times(at.slope()));
    Scalar square = e.one().plus(at.slope().squared());
    Scalar full = square.plus(at.height().minus(z).times(at.bend()));
    Scalar rise = e.function(MathFunction.MAX, full, square.times(ClosestPoint.LEAST));
    Scalar way = x.minus(s);
    Scalar up = z.minus(at.height());
    Scalar length = square.times(way.squared().plus(up.squared())).squareRoot();
    Scalar size = e.function(MathFunction.ABS, g);
    Scalar smooth = pick(size, length.times(ClosestPoint.CORNER), rise, e.constant(FAR));
    // the step has no length; its derivative is that of s
    return s.minus(g.minus(held(g)).over(smooth));
  }

  /** Returns the number whose size is larger, the second if they are equal. */
  private Scalar larger(Scalar size, Scalar otherSize, Scalar first, Scalar second) {
    return e.function(MathFunction.CHOOSE, held(size), held(otherSize), second, first);
  }

  private Scalar held(Scalar value) {
    return e.function(MathFunction.HELD, value);
  }

  private Scalar searched(Curve curve, Scalar x, Scalar z) {
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
      Scalar up = at.height().minus(z);
      Scalar g = s.minus(x).plus(up.times(at.slope()));
      Scalar rise = e.one().plus(at.slope().squared()).plus(up.times(at.bend()));
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
  private Scalar between(Scalar low, Scalar value, Scalar high, Scalar other) {
    return pick(low, value, pick(value, high, value, other), other);
  }

  private Scalar pick(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.PICK, a, b, first, second);
  }
}
