package org.mechservice.solver.force.law;

import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * Distance and normal at the point of a curve z = h(s) that is closest to a point (x, z), from the
 * abscissa s that a search has found. Legend: θ the angle of slope, tan θ = h′(s); (−sin θ, cos θ)
 * the normal; σ the distance along it, positive above the curve; g(s) = s − x + (h(s) − z) h′(s)
 * half of the derivative of the squared distance.
 *
 * <p>The search has no derivatives; those of s are the derivatives of one step of Newton's method
 * on g = 0, which has no length.
 *
 * <p>At a corner of the surface the point is no foot of a perpendicular: σ is then the way to it,
 * and the normal its direction. The curve of a sphere's centre has no corners.
 */
public final class ClosestFoot {
  /** A curve at a place. */
  public interface Curve {
    /** Returns the place s, m. */
    Scalar way();

    /** Returns h(s), m. */
    Scalar height();

    /** Returns h′(s). */
    Scalar slope();

    /** Returns h″(s), 1/m. */
    Scalar bend();

    /** Returns the curve at a place further on, m. */
    Curve moved(Scalar by);
  }

  /** Least of 1 − σ κ, with κ the curvature: at the centre of curvature s has no derivative. */
  private static final double LEAST = 1e-6;

  /**
   * Largest angle between the normal and the way to a foot of a perpendicular, rad; at a corner of
   * the surface, where s does not move, it is larger. A search that has converged leaves 1e-12.
   */
  private static final double CORNER = 1e-7;

  /** Rounding of g, by |x| + |z| and √(1 + h′²): some fifty units in the last place. */
  private static final double ROUNDING = 1e-14;

  /** Divides a step where s does not move. */
  private static final double FAR = 1e300;

  private final Expressions e;
  private final Scalar x;
  private final Scalar z;
  private final boolean ofCentre;

  /** σ, m. */
  public final Scalar distance;

  public final Scalar sine;
  public final Scalar cosine;

  /**
   * Derives the foot on a straight line, by one step of Newton's method from any place.
   *
   * @param line at any place
   * @param ofCentre whether the curve is that of the sphere's centre, else the surface
   */
  public ClosestFoot(Curve line, Scalar x, Scalar z, boolean ofCentre) {
    this.e = x.expressions();
    this.x = x;
    this.z = z;
    this.ofCentre = ofCentre;
    Scalar rise = e.one().plus(line.slope().squared());
    Curve at = line.moved(g(line).over(rise).negated());
    Scalar root = root(at);
    distance = along(at);
    sine = at.slope().over(root);
    cosine = e.one().over(root);
  }

  /**
   * Derives the foot on a curve.
   *
   * @param near the curve at the closest point
   * @param below h(x), m
   * @param ofCentre whether the curve is that of the sphere's centre, else the surface
   */
  public ClosestFoot(Curve near, Scalar below, Scalar x, Scalar z, boolean ofCentre) {
    this.e = x.expressions();
    this.x = x;
    this.z = z;
    this.ofCentre = ofCentre;
    Scalar g = g(near);
    Scalar full = rise(near);
    Scalar least = e.one().plus(near.slope().squared()).times(LEAST);
    Scalar rise = pick(full, least, least, full);
    Scalar size = held(e.function(MathFunction.ABS, g));
    Scalar limit = held(limit(near));
    Scalar moves = ofCentre ? rise : pick(size, limit, rise, e.constant(FAR));
    // the step has no length; its derivative is that of s
    Curve at = near.moved(g.minus(held(g)).over(moves).negated());
    Scalar root = root(at);
    Scalar along = along(at);
    Scalar level = e.one().over(root);
    Scalar slant = at.slope().over(root);
    if (ofCentre) {
      distance = along;
      sine = slant;
      cosine = level;
      return;
    }
    // choices between what is equal where they change are no switches
    Scalar direct = direct(at);
    Scalar side = choose(held(z), held(below), direct.negated(), direct);
    Scalar towards = at.way().minus(x).over(side);
    Scalar up = z.minus(at.height()).over(side);
    distance = choose(size, limit, along, side);
    sine = choose(size, limit, slant, towards);
    cosine = choose(size, limit, level, up);
  }

  /** Returns whether the curve is that of the sphere's centre, else the surface. */
  boolean isOfCentre() {
    return ofCentre;
  }

  /** Returns the largest |g| of a foot of a perpendicular. */
  private Scalar limit(Curve at) {
    Scalar size = e.function(MathFunction.ABS, x).plus(e.function(MathFunction.ABS, z));
    return root(at).times(direct(at).times(CORNER).plus(size.times(ROUNDING)));
  }

  private Scalar root(Curve at) {
    return e.one().plus(at.slope().squared()).squareRoot();
  }

  private Scalar direct(Curve at) {
    return x.minus(at.way()).squared().plus(z.minus(at.height()).squared()).squareRoot();
  }

  private Scalar along(Curve at) {
    return z.minus(at.height()).minus(at.slope().times(x.minus(at.way()))).over(root(at));
  }

  private Scalar g(Curve at) {
    return g(at, x, z);
  }

  private Scalar rise(Curve at) {
    return rise(at, z);
  }

  /** Returns g. */
  public static Scalar g(Curve at, Scalar x, Scalar z) {
    return at.way().minus(x).plus(at.height().minus(z).times(at.slope()));
  }

  /** Returns g′. */
  public static Scalar rise(Curve at, Scalar z) {
    return z.expressions()
        .one()
        .plus(at.slope().squared())
        .plus(at.height().minus(z).times(at.bend()));
  }

  private Scalar held(Scalar value) {
    return e.function(MathFunction.HELD, value);
  }

  private Scalar choose(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.CHOOSE, a, b, first, second);
  }

  private Scalar pick(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.PICK, a, b, first, second);
  }
}
