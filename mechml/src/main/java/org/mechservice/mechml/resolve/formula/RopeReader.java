package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
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
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;

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
 * taken between −π/2 and 3π/2. Where it is negative the rope has left the pulley and runs straight
 * past it; length and slope of the length are continuous there. An offset h along n makes a
 * straight part √(ℓ² + h²) long.
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
  record Stop(BodyPoint centre, Expression signedRadius, Expression radius, Expression turns) {
    boolean isEye() {
      return radius.equals(Expression.ZERO);
    }

    boolean isLeft() {
      return signedRadius.equals(radius);
    }

    /** Returns whether the rope can leave it, which it does not with whole turns on it. */
    boolean canBeLeft() {
      return !isEye() && turns.equals(Expression.ZERO);
    }
  }

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
    int most = mostBetweenEyes(stops);
    if (most > RopeSection.MOST_PULLEYS) {
      relations.report(
          element,
          Phrase.of(
              "%d pulleys follow each other without an eye; there may be %d, because the rope can"
                  + " leave each of them; write a via between them",
              most, RopeSection.MOST_PULLEYS));
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

  /** Returns the largest number of pulleys between two eyes that the rope can leave. */
  private static int mostBetweenEyes(List<Stop> stops) {
    int most = 0;
    int count = 0;
    for (Stop stop : stops) {
      count = stop.isEye() ? 0 : stop.canBeLeft() ? count + 1 : count;
      most = Math.max(most, count);
    }
    return most;
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
    Expression length = Expression.ZERO;
    int from = 0;
    for (int i = 1; i < stops.size(); i++) {
      if (stops.get(i).isEye()) {
        length =
            RelationReader.plus(
                length, new RopeSection(plane, stops.subList(from, i + 1)).length());
        from = i;
      }
    }
    return length;
  }

  /** Returns the way between two points along a vector fixed in the plane's body. */
  static Expression along(BodyFrame plane, Vector3 axis, BodyPoint from, BodyPoint to) {
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

  static Expression minus(Expression left, Expression right) {
    return right.equals(Expression.ZERO) ? left : new Sum(left, new Negation(right));
  }

  static Expression root(Expression square) {
    return Expression.call(MathFunction.SQRT, List.of(square));
  }
}
