package org.mechservice.sim.equations.force;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.MathFunction;
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
   */
  record Curve(Scalar way, Scalar height, Scalar slope, Scalar bend) {
    private Curve at(Scalar s) {
      Substitution place = new Substitution(way, s);
      return new Curve(s, place.of(height), place.of(slope), place.of(bend));
    }
  }

  /** σ, m. */
  final Scalar distance;

  final Scalar sine;
  final Scalar cosine;

  /** Positive where the search converged, or where the sphere is its radius above a touch. */
  final Scalar certainty;

  /**
   * @param radius of the sphere around (x, z), m
   */
  ClosestPointSearch(Curve curve, Scalar x, Scalar z, Scalar radius) {
    Expressions e = x.expressions();
    Scalar one = e.one();
    Curve below = curve.at(x);
    Curve at = below;
    Scalar step = e.zero();
    boolean straight = curve.bend().isZero();
    for (int i = 0; i < (straight ? 1 : ClosestPoint.STEPS) && !curve.slope().isZero(); i++) {
      Scalar g = at.way().minus(x).plus(at.height().minus(z).times(at.slope()));
      Scalar square = one.plus(at.slope().squared());
      Scalar full = square.plus(at.height().minus(z).times(at.bend()));
      Scalar divisor =
          straight ? square : e.function(MathFunction.MAX, full, square.times(ClosestPoint.LEAST));
      step = g.over(divisor);
      at = curve.at(at.way().minus(step));
    }
    Scalar root = one.plus(at.slope().squared()).squareRoot();
    cosine = one.over(root);
    sine = at.slope().over(root);
    Scalar way = x.minus(at.way());
    Scalar up = z.minus(at.height());
    Scalar along = up.minus(at.slope().times(way)).over(root);
    if (straight) {
      distance = along;
      certainty = one;
      return;
    }
    Scalar direct = way.squared().plus(up.squared()).squareRoot();
    Scalar larger = e.function(MathFunction.MAX, along, direct);
    distance = e.function(MathFunction.CHOOSE, z, below.height(), along, larger);
    Scalar tilt = one.plus(below.slope().squared()).squareRoot();
    Scalar top = below.height().plus(tilt.plus(one).times(radius));
    Scalar size =
        radius
            .plus(e.function(MathFunction.ABS, way))
            .plus(e.function(MathFunction.ABS, up))
            .times(ClosestPoint.CONVERGED);
    Scalar converged = size.minus(e.function(MathFunction.ABS, step));
    certainty =
        e.function(
            MathFunction.CHOOSE,
            top,
            z,
            one,
            e.function(MathFunction.CHOOSE, e.zero(), converged, one, e.zero()));
  }

  /** Returns whether the search finds the point whatever the place. */
  boolean isCertain() {
    return certainty.isConstant();
  }
}
