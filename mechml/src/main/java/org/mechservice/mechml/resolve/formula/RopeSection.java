package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;

/**
 * A rope from one eye over pulleys to the next: its length by the pulleys that it touches. {@link
 * RopeReader} has the geometry of a straight part and of an arc.
 *
 * <p>With all pulleys in a set touched, the first one whose arc is negative is left: the length is
 * that of the set without it. So each set has one length, which is written once.
 */
final class RopeSection {
  /** Most pulleys that can be left: the number of sets is two to this power. */
  static final int MOST_PULLEYS = 8;

  /** Keeps a straight part between pulleys that overlap finite, m². */
  private static final Expression TINY = Expression.of(1e-30);

  private final List<RopeReader.Stop> stops;
  private final Vector3 x;
  private final Vector3 y;
  private final Vector3 z;
  private final BodyFrame plane;
  private final Map<Integer, Straight> straights = new HashMap<>();
  private final Map<List<Integer>, Expression> angles = new HashMap<>();
  private final Map<List<Integer>, Expression> lengths = new HashMap<>();

  /**
   * @param plane of the pulleys
   * @param stops an eye, pulleys, an eye
   */
  RopeSection(BodyFrame plane, List<RopeReader.Stop> stops) {
    this.plane = plane;
    this.stops = stops;
    x = plane.axes().apply(new Vector3(1, 0, 0));
    y = plane.axes().apply(new Vector3(0, 1, 0));
    z = plane.axes().apply(new Vector3(0, 0, 1));
  }

  /** A straight part: its direction in the plane, times a positive number, and its length. */
  private record Straight(Expression ux, Expression uy, Expression length) {}

  /** Returns the length between the eyes, m. */
  Expression length() {
    return length(IntStream.range(0, stops.size()).boxed().toList());
  }

  /** Returns the length if the rope passes some of the stops at most. */
  private Expression length(List<Integer> passed) {
    Expression known = lengths.get(passed);
    if (known != null) {
      return known;
    }
    Expression length = touching(passed);
    for (int k = passed.size() - 2; k > 0; k--) {
      if (stops.get(passed.get(k)).canBeLeft()) {
        List<Integer> rest = new ArrayList<>(passed);
        rest.remove(k);
        Expression touched =
            Expression.call(
                MathFunction.STEP,
                List.of(angle(passed.get(k - 1), passed.get(k), passed.get(k + 1))));
        Expression left = RopeReader.minus(Expression.of(1), touched);
        length = new Sum(new Product(touched, length), new Product(left, length(rest)));
      }
    }
    lengths.put(passed, length);
    return length;
  }

  /** Returns the length if the rope touches all of some stops. */
  private Expression touching(List<Integer> passed) {
    Expression length = Expression.ZERO;
    for (int k = 1; k < passed.size(); k++) {
      int from = passed.get(k - 1);
      if (k > 1) {
        length = new Sum(length, arc(passed.get(k - 2), from, passed.get(k)));
      }
      length = RelationReader.plus(length, straight(from, passed.get(k)).length());
    }
    return length;
  }

  private Straight straight(int i, int j) {
    return straights.computeIfAbsent(i * stops.size() + j, key -> between(i, j));
  }

  private Straight between(int i, int j) {
    RopeReader.Stop from = stops.get(i);
    RopeReader.Stop to = stops.get(j);
    Expression dx = RopeReader.along(plane, x, from.centre(), to.centre());
    Expression dy = RopeReader.along(plane, y, from.centre(), to.centre());
    Expression h = RopeReader.along(plane, z, from.centre(), to.centre());
    Expression delta = RopeReader.minus(to.signedRadius(), from.signedRadius());
    Expression square = new Sum(new Product(dx, dx), new Product(dy, dy));
    Expression inPlane = RopeReader.minus(square, new Product(delta, delta));
    if (j > i + 1) {
      inPlane = Expression.call(MathFunction.MAX, List.of(inPlane, TINY));
    }
    Expression tangent = RopeReader.root(inPlane);
    Expression ux = new Sum(new Product(tangent, dx), new Product(delta, dy));
    Expression uy = RopeReader.minus(new Product(tangent, dy), new Product(delta, dx));
    return new Straight(ux, uy, RopeReader.root(new Sum(inPlane, new Product(h, h))));
  }

  /** Returns π/2 + atan2(−u·w, s n·(u × w)), u before a pulley, w behind it. */
  private Expression angle(int before, int pulley, int behind) {
    return angles.computeIfAbsent(
        List.of(before, pulley, behind),
        key -> turn(straight(before, pulley), straight(pulley, behind), stops.get(pulley)));
  }

  private static Expression turn(Straight before, Straight behind, RopeReader.Stop pulley) {
    Expression dot =
        new Sum(new Product(before.ux(), behind.ux()), new Product(before.uy(), behind.uy()));
    Expression cross =
        RopeReader.minus(
            new Product(before.ux(), behind.uy()), new Product(before.uy(), behind.ux()));
    Expression angle =
        Expression.call(
            MathFunction.ATAN2,
            List.of(new Negation(dot), pulley.isLeft() ? cross : new Negation(cross)));
    return new Sum(Expression.of(Math.PI / 2), angle);
  }

  /** Returns the length on a pulley, its whole turns included. */
  private Expression arc(int before, int pulley, int behind) {
    RopeReader.Stop stop = stops.get(pulley);
    Expression whole = new Product(Expression.of(2 * Math.PI), stop.turns());
    return new Product(stop.radius(), new Sum(whole, angle(before, pulley, behind)));
  }
}
