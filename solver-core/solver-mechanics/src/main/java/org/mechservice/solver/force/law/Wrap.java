package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The shortest way of a string from one point to another over a sphere or a cylinder between them.
 *
 * <p>Legend: a, b from the centre to the points, of a cylinder their parts normal to its axis; R
 * the radius; ψ the angle between a and b; t = √(a² − R²) the length of a tangent, β = atan(t/R)
 * the angle at the centre to its point of contact. Over the arc of the angle θ the way is
 *
 * <pre>
 * W = t_a + t_b + R θ,  θ = ψ − β_a − β_b the short way round, 2π − ψ − β_a − β_b the long one
 * </pre>
 *
 * and over a cylinder √(W² + h²) with the way h along the axis, because the string is straight on
 * the unrolled cylinder. Where the points of contact move, the way does not change to first order,
 * so that the slopes of W are those of the straight parts alone: moment arms follow by
 * differentiation.
 *
 * <p>Without a side the string takes the short way, and lies on the shape while θ is positive: way
 * and slope are continuous where it begins and ends. With a side it takes the long way where the
 * side lies opposite the angle between a and b, so that it passes on that side though the straight
 * line does not; elsewhere it is as without. Where an end passes beside the line from the side
 * through the centre, the way jumps between both. A string one of whose ends is inside the shape
 * runs straight. From inside it is held in a ring, and touches it at {@link
 * org.mechservice.solver.spatial.TouchingPoint one point} while the straight line passes outside.
 *
 * <p>These are the ways of MuJoCo 4.0 (documentation, XML reference, {@code spatial} and {@code
 * geom}); that of a side was read from its lengths at random places.
 */
public final class Wrap {
  /** Least square of a length, m², that keeps slopes finite where they do not count. */
  private static final double TINY = 1e-30;

  /** The same of an area. */
  private static final double TINY_AREA = 1e-60;

  /**
   * Part of a product of lengths that counts as nothing: a side that is an end of the string, as
   * files often have it, is not opposite.
   */
  private static final double ROUNDING = 1e-12;

  private final Expressions e;

  /** The ends, from the centre, and their parts about the axis. */
  private final ScalarVector from;

  private final ScalarVector to;
  private final ScalarVector a;
  private final ScalarVector b;
  private final Optional<ScalarVector> axis;
  private final Scalar radius;
  private final Scalar aa;
  private final Scalar bb;
  private final Scalar ab;
  private final ScalarVector normal;

  /** |a × b|, |a|, |b|. */
  private final Scalar area;

  private final Scalar la;
  private final Scalar lb;
  private final Scalar ta;
  private final Scalar tb;
  private final Scalar betaA;
  private final Scalar betaB;
  private final Scalar psi;

  /** θ of the short way. */
  private final Scalar shortArc;

  /** Not negative while both ends are outside. */
  private final Scalar outside;

  /**
   * A way.
   *
   * @param length m
   * @param margins numbers whose signs tell the form of the way: not negative on one side
   */
  public record Way(Scalar length, List<Scalar> margins) {
    public Way {
      margins = List.copyOf(margins);
    }
  }

  /**
   * @param from from the centre to the point before the shape, in world axes, m
   * @param to likewise to the point behind it
   * @param axis unit vector of a cylinder's axis, in world axes; empty of a sphere
   * @param radius positive, m
   */
  public Wrap(
      Expressions e,
      ScalarVector from,
      ScalarVector to,
      Optional<ScalarVector> axis,
      Scalar radius) {
    this.e = e;
    this.from = from;
    this.to = to;
    this.axis = axis;
    this.radius = radius;
    a = acrossAxis(from);
    b = acrossAxis(to);
    aa = a.dot(a);
    bb = b.dot(b);
    ab = a.dot(b);
    normal = a.cross(b);
    area = root(normal.dot(normal), TINY_AREA);
    la = root(aa, TINY);
    lb = root(bb, TINY);
    Scalar square = radius.squared();
    ta = root(aa.minus(square), TINY);
    tb = root(bb.minus(square), TINY);
    betaA = angle(ta, radius);
    betaB = angle(tb, radius);
    psi = angle(area, ab);
    shortArc = psi.minus(betaA).minus(betaB);
    outside = lesser(aa.minus(square), bb.minus(square));
  }

  private ScalarVector acrossAxis(ScalarVector v) {
    return axis.map(n -> v.minus(n.times(n.dot(v)))).orElse(v);
  }

  /** Returns the shortest way. */
  public Way shortest() {
    Scalar wraps = lesser(outside, shortArc);
    return new Way(where(wraps, whole(tangent(shortArc)), straight()), List.of(wraps));
  }

  /**
   * Returns the way on the side of a point.
   *
   * @param side from the centre, in world axes, m; not inside the shape
   */
  public Way beside(ScalarVector side) {
    Scalar sa = side.dot(a);
    Scalar sb = side.dot(b);
    // components of the side along a and b, times |a × b|², beside what rounding leaves of them
    Scalar size = root(side.dot(side), TINY).times(ROUNDING);
    Scalar alongA = sa.times(bb).minus(sb.times(ab)).plus(size.times(la).times(bb));
    Scalar alongB = sb.times(aa).minus(sa.times(ab)).plus(size.times(lb).times(aa));
    Scalar opposite = greater(alongA, alongB).negated();
    Scalar longArc = e.constant(2 * Math.PI).minus(psi).minus(betaA).minus(betaB);
    Scalar wraps = lesser(outside, greater(opposite, shortArc));
    Scalar way = where(opposite, tangent(longArc), tangent(shortArc));
    return new Way(
        where(wraps, whole(way), straight()), List.of(wraps, where(outside, opposite, e.one())));
  }

  /**
   * Returns the way inside a ring.
   *
   * <p>The touching point P is found by a search and held in the body of the ring, which gives the
   * slopes of the way exactly. How P moves shows in the second derivatives: −g²/(2 L″), with the
   * slope g of the way along the ring at the held P, has no value and no slope there, and the bend
   * that is missing.
   *
   * @param axes three unit vectors fixed in the body of the shape, normal to each other, in world
   *     axes
   * @param tolerance as {@link org.mechservice.solver.spatial.TouchingPoint} takes it
   */
  public Way inside(List<ScalarVector> axes, double tolerance) {
    Scalar turn = turnToTouch(tolerance);
    ScalarVector first = a.times(e.one().over(la));
    ScalarVector binormal = normal.times(e.one().over(area));
    ScalarVector second = binormal.cross(first);
    Scalar cosine = e.cosine(turn);
    Scalar sine = e.sine(turn);
    ScalarVector radial = held(first.times(cosine).plus(second.times(sine)), axes);
    ScalarVector tangent = held(second.times(cosine).minus(first.times(sine)), axes);
    ScalarVector p = radial.times(radius);
    ScalarVector toA = p.minus(a);
    ScalarVector toB = p.minus(b);
    Scalar lengthA = root(toA.dot(toA), TINY);
    Scalar lengthB = root(toB.dot(toB), TINY);
    ScalarVector pull = toA.times(e.one().over(lengthA)).plus(toB.times(e.one().over(lengthB)));
    Scalar bow =
        bow(
            pull.dot(tangent),
            bend(toA, lengthA, radial, tangent).plus(bend(toB, lengthB, radial, tangent)));
    if (axis.isEmpty()) {
      ScalarVector out = held(binormal, axes);
      bow =
          bow.plus(
              bow(
                  pull.dot(out),
                  bend(toA, lengthA, radial, out).plus(bend(toB, lengthB, radial, out))));
    }
    // negative where the line meets the shape, whose nearest point is between the ends
    Scalar touches = lesser(outside, shortArc.negated());
    Scalar way = whole(lengthA.plus(lengthB).plus(bow));
    Scalar smooth = e.whole(MathFunction.SMOOTH, List.of(way));
    return new Way(where(touches, smooth, straight()), List.of(touches));
  }

  /**
   * Returns the angle from a to the touching point. On a cylinder MuJoCo starts from the end from
   * which the way turns about the axis by the right hand.
   */
  private Scalar turnToTouch(double tolerance) {
    Scalar limit = e.constant(tolerance);
    Scalar hand = axis.map(n -> n.dot(normal)).orElse(e.one());
    Scalar start = e.function(MathFunction.PICK, e.zero(), hand, la, lb);
    Scalar end = e.function(MathFunction.PICK, e.zero(), hand, lb, la);
    Scalar found = e.function(MathFunction.TOUCH, start, end, psi, radius, limit);
    return e.function(MathFunction.PICK, e.zero(), hand, found, held(psi).minus(found));
  }

  /** Returns how the distance to a point bends as it moves on the shape along a tangent. */
  private Scalar bend(ScalarVector way, Scalar length, ScalarVector radial, ScalarVector tangent) {
    Scalar square = way.dot(tangent).over(length).squared();
    Scalar fall = way.dot(radial).over(radius);
    return e.one().minus(square).minus(fall).over(length);
  }

  /** Returns −(g − g₀)²/(2 L″), with g₀ the value of g. */
  private Scalar bow(Scalar slope, Scalar bend) {
    return slope.minus(held(slope)).squared().over(held(bend).times(-2));
  }

  private Scalar held(Scalar x) {
    return e.function(MathFunction.HELD, x);
  }

  /** Returns a vector that keeps its components in axes. */
  private ScalarVector held(ScalarVector v, List<ScalarVector> axes) {
    ScalarVector sum = ScalarVector.zero(e);
    for (ScalarVector one : axes) {
      sum = sum.plus(one.times(held(v.dot(one))));
    }
    return sum;
  }

  private Scalar tangent(Scalar arc) {
    return ta.plus(tb).plus(radius.times(arc));
  }

  private Scalar whole(Scalar way) {
    return axis.map(n -> root(way.squared().plus(n.dot(to).minus(n.dot(from)).squared()), TINY))
        .orElse(way);
  }

  private Scalar straight() {
    ScalarVector way = to.minus(from);
    return root(way.dot(way), TINY);
  }

  private Scalar root(Scalar square, double least) {
    return greater(square, e.constant(least)).squareRoot();
  }

  private Scalar angle(Scalar y, Scalar x) {
    return e.function(MathFunction.ATAN2, y, x);
  }

  private Scalar where(Scalar margin, Scalar one, Scalar other) {
    return e.function(MathFunction.CHOOSE, e.zero(), margin, one, other);
  }

  private Scalar lesser(Scalar x, Scalar y) {
    return e.function(MathFunction.MIN, x, y);
  }

  private Scalar greater(Scalar x, Scalar y) {
    return e.function(MathFunction.MAX, x, y);
  }
}
