package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Function;
import org.mechservice.solver.spatial.Vector3;

/**
 * The length of a rope as a formula of the places of points: the straight parts between eyes and
 * pulleys, the arcs on the pulleys, and what {@code term}s add, such as the rope on a drum.
 *
 * <p>Legend: in the rope's plane with normal n, pulley i has the centre C, the radius R ≥ 0 (an eye
 * has 0) and s = 1 if it lies to the left of the rope, −1 to the right. The straight part from i to
 * j has the direction u and the length ℓ; with d = C_j − C_i and Δ = s_j R_j − s_i R_i
 *
 * <pre>
 * d = ℓ u + Δ n × u,  ℓ² = d · d − Δ²,  u ∥ ℓ d − Δ n × d
 * </pre>
 *
 * The arc on a pulley is R times the angle from the direction before it to that behind it, which is
 * taken between −π/2 and 3π/2. An offset h along n makes a straight part √(ℓ² + h²) long.
 */
public final class RopeReader {
  private final FormulaReader formulas;
  private final RelationReader relations;
  private final FrameReader frames;
  private final MechanismNames names;
  private final ValueReader values;

  public RopeReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.relations = new RelationReader(formulas, names, diagnostics);
    this.frames = new FrameReader(names, diagnostics);
    this.names = names;
  }

  /**
   * A rope.
   *
   * @param length its length, m
   * @param points what it passes, from its first end to its last
   */
  public record Rope(Expression length, List<BodyPoint> points) {
    public Rope {
      points = List.copyOf(points);
    }
  }

  /**
   * An eye or a pulley on the way of a rope.
   *
   * @param centre of the pulley, or the eye
   * @param signedRadius s R, m; 0 for an eye
   * @param radius R
   * @param turns whole turns on the pulley beside the arc
   */
  private record Stop(
      BodyPoint centre, Expression signedRadius, Expression radius, Expression turns) {}

  /** The straight part behind a stop: its direction in the plane and its length. */
  private record Straight(Expression ux, Expression uy, Expression length) {}

  /** Returns the rope of an element; empty after a reported error. */
  public Optional<Rope> read(Element element) {
    List<Stop> stops = new ArrayList<>();
    int wanted = 0;
    boolean pulleys = false;
    for (Element child : element.children()) {
      if (child.name().equals("via") || child.name().equals("pulley")) {
        wanted++;
        pulleys |= child.name().equals("pulley");
        stop(child).ifPresent(stops::add);
      }
    }
    Optional<Element> plane = element.child("plane");
    if (!isPossible(element, pulleys, plane.isPresent())) {
      return Optional.empty();
    }
    Optional<BodyFrame> frame = plane.flatMap(this::frame);
    Optional<Expression> more =
        relations
            .sum(element, Expression.ZERO)
            .map(sum -> FormulaNames.toSi(sum, values.units().length()));
    if (stops.size() < wanted || more.isEmpty() || (plane.isPresent() && frame.isEmpty())) {
      return Optional.empty();
    }
    Expression length = frame.isPresent() ? overPulleys(frame.get(), stops) : throughEyes(stops);
    return Optional.of(
        new Rope(
            RelationReader.plus(more.get(), length), stops.stream().map(Stop::centre).toList()));
  }

  private boolean isPossible(Element element, boolean pulleys, boolean plane) {
    List<Element> stops =
        element.children().stream()
            .filter(child -> child.name().equals("via") || child.name().equals("pulley"))
            .toList();
    if (stops.size() < 2
        || stops.get(0).name().equals("pulley")
        || stops.get(stops.size() - 1).name().equals("pulley")) {
      relations.report(element, "a rope begins and ends at a via; write a via at both ends");
      return false;
    }
    if (pulleys != plane) {
      relations.report(
          element,
          pulleys
              ? "a rope over pulleys needs a plane, whose vector is normal to the pulleys"
              : "a plane has no meaning for a rope without pulleys; leave it out");
      return false;
    }
    return true;
  }

  private Optional<BodyFrame> frame(Element plane) {
    return frames.direction(plane, "normal to the pulleys").flatMap(n -> frames.read(plane));
  }

  private Optional<Stop> stop(Element element) {
    Optional<BodyPoint> centre = names.point(element);
    if (element.name().equals("via")) {
      return centre.map(at -> new Stop(at, Expression.ZERO, Expression.ZERO, Expression.ZERO));
    }
    Optional<Expression> radius = formulas.positive(element, "radius", Quantity.LENGTH);
    Optional<Expression> turns = formulas.notNegative(element, "turns", Quantity.NUMBER);
    boolean left = element.required("side").equals("left");
    return centre.isPresent() && radius.isPresent() && turns.isPresent()
        ? Optional.of(
            new Stop(
                centre.get(),
                left ? radius.get() : new Negation(radius.get()),
                radius.get(),
                turns.get()))
        : Optional.empty();
  }

  private static Expression throughEyes(List<Stop> stops) {
    Expression length = Expression.ZERO;
    for (int i = 1; i < stops.size(); i++) {
      Expression squares = Expression.ZERO;
      for (int axis = 0; axis < 3; axis++) {
        Expression way =
            minus(
                new PointPosition(stops.get(i).centre(), axis),
                new PointPosition(stops.get(i - 1).centre(), axis));
        squares = RelationReader.plus(squares, new Product(way, way));
      }
      length = RelationReader.plus(length, root(squares));
    }
    return length;
  }

  private static Expression overPulleys(BodyFrame plane, List<Stop> stops) {
    Vector3 x = plane.axes().apply(new Vector3(1, 0, 0));
    Vector3 y = plane.axes().apply(new Vector3(0, 1, 0));
    Vector3 z = plane.axes().apply(new Vector3(0, 0, 1));
    List<Straight> straights = new ArrayList<>();
    Expression length = Expression.ZERO;
    for (int i = 1; i < stops.size(); i++) {
      Stop from = stops.get(i - 1);
      Stop to = stops.get(i);
      Expression dx = along(plane, x, from.centre(), to.centre());
      Expression dy = along(plane, y, from.centre(), to.centre());
      Expression h = along(plane, z, from.centre(), to.centre());
      Expression delta = minus(to.signedRadius(), from.signedRadius());
      Expression square = new Sum(new Product(dx, dx), new Product(dy, dy));
      Expression inPlane = minus(square, new Product(delta, delta));
      Expression tangent = root(inPlane);
      Expression ux = new Sum(new Product(tangent, dx), new Product(delta, dy));
      Expression uy = minus(new Product(tangent, dy), new Product(delta, dx));
      Straight straight = new Straight(ux, uy, root(new Sum(inPlane, new Product(h, h))));
      if (i > 1) {
        length = new Sum(length, arc(from, straights.get(i - 2), straight));
      }
      straights.add(straight);
      length = RelationReader.plus(length, straight.length());
    }
    return length;
  }

  /** R (π/2 + atan2(−u·w, s n·(u × w)) + 2π turns), u before the pulley, w behind it. */
  private static Expression arc(Stop pulley, Straight before, Straight behind) {
    if (pulley.radius().equals(Expression.ZERO)) {
      return Expression.ZERO;
    }
    Expression dot =
        new Sum(new Product(before.ux(), behind.ux()), new Product(before.uy(), behind.uy()));
    Expression cross =
        minus(new Product(before.ux(), behind.uy()), new Product(before.uy(), behind.ux()));
    boolean left = pulley.signedRadius().equals(pulley.radius());
    Expression angle =
        Expression.call(
            Function.ATAN2, List.of(new Negation(dot), left ? cross : new Negation(cross)));
    Expression start =
        new Sum(
            Expression.of(Math.PI / 2), new Product(Expression.of(2 * Math.PI), pulley.turns()));
    return new Product(pulley.radius(), new Sum(start, angle));
  }

  /** Returns the way between two points along a vector fixed in the plane's body. */
  private static Expression along(BodyFrame plane, Vector3 axis, BodyPoint from, BodyPoint to) {
    BodyPoint origin = new BodyPoint(plane.body(), plane.position());
    BodyPoint tip = new BodyPoint(plane.body(), plane.position().plus(axis));
    Expression sum = Expression.ZERO;
    for (int k = 0; k < 3; k++) {
      Expression way = minus(new PointPosition(to, k), new PointPosition(from, k));
      Expression unit = minus(new PointPosition(tip, k), new PointPosition(origin, k));
      sum = RelationReader.plus(sum, new Product(way, unit));
    }
    return sum;
  }

  private static Expression minus(Expression left, Expression right) {
    return right.equals(Expression.ZERO) ? left : new Sum(left, new Negation(right));
  }

  private static Expression root(Expression square) {
    return Expression.call(Function.SQRT, List.of(square));
  }
}
