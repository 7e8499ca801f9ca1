package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.Route;
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
 * pulleys, the arcs on the pulleys and around spheres and cylinders ({@link WrapSection}), and what
 * {@code term}s add, such as the rope on a drum. Behind a {@code branch} the rope begins anew, and
 * a share of its length counts.
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
  private static final Set<String> STOPS = Set.of("via", "pulley", "around", "branch");

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
   * @param changes formulas that tell where the form of the length changes
   */
  public record Rope(Expression length, List<BodyPoint> points, List<Expression> changes) {
    public Rope {
      points = List.copyOf(points);
      changes = List.copyOf(changes);
    }
  }

  /**
   * An eye, a pulley, a shape or a branch on the way of a rope.
   *
   * @param centre of the pulley or the shape, or the eye; of a branch that of what is before it
   * @param signedRadius s R, m; 0 for an eye
   * @param radius R
   * @param turns whole turns on the pulley beside the arc
   * @param shape that the rope goes around; empty of others
   * @param share of a branch, of the length behind it; empty of others
   */
  record Stop(
      BodyPoint centre,
      Expression signedRadius,
      Expression radius,
      Expression turns,
      Optional<WrapSection.Shape> shape,
      Optional<Expression> share) {
    static Stop eye(BodyPoint at) {
      return new Stop(
          at,
          Expression.ZERO,
          Expression.ZERO,
          Expression.ZERO,
          Optional.empty(),
          Optional.empty());
    }

    boolean isEye() {
      return radius.equals(Expression.ZERO) && shape.isEmpty() && share.isEmpty();
    }

    boolean isLeft() {
      return signedRadius.equals(radius);
    }

    /** Returns whether the rope can leave it, which it does not with whole turns on it. */
    boolean canBeLeft() {
      return isPulley() && turns.equals(Expression.ZERO);
    }

    /** Returns what pictures show of it. */
    Route.Stop passed() {
      if (shape.isPresent()) {
        WrapSection.Shape round = shape.get();
        return new Route.Around(centre, round.axis(), round.radius(), round.side(), round.inside());
      } else if (share.isPresent()) {
        return new Route.Branch();
      }
      return isEye()
          ? new Route.Eye(centre)
          : new Route.Pulley(centre, radius, isLeft(), !canBeLeft());
    }

    boolean isPulley() {
      return !isEye() && shape.isEmpty() && share.isEmpty();
    }
  }

  /**
   * Returns what the ropes, cables and muscles of a model pass, by their names; to be called for a
   * file without errors.
   */
  public Map<String, Route> routes(Element model) {
    Map<String, Route> routes = new HashMap<>();
    for (String section : List.of("Constraints", "Forces")) {
      for (Element element : model.child(section).map(Element::children).orElse(List.of())) {
        if (!element.children("via").isEmpty()) {
          routes.put(element.required("name"), route(element));
        }
      }
    }
    return routes;
  }

  private Route route(Element element) {
    List<Route.Stop> stops = new ArrayList<>();
    for (Element child : element.children()) {
      if (STOPS.contains(child.name())) {
        stop(child).map(Stop::passed).ifPresent(stops::add);
      }
    }
    Optional<BodyFrame> plane = element.child("plane").flatMap(this::frame);
    return new Route(stops, plane, element.name().equals("muscle"));
  }

  /** Returns the rope of an element; empty after a reported error. */
  public Optional<Rope> read(Element element) {
    return read(element, false);
  }

  /**
   * Returns the rope of an element, or the sum of its terms alone; empty after a reported error.
   */
  public Optional<Rope> readOrSum(Element element) {
    return read(element, true);
  }

  private Optional<Rope> read(Element element, boolean sumAlone) {
    List<Stop> stops = new ArrayList<>();
    List<Element> wanted =
        element.children().stream().filter(child -> STOPS.contains(child.name())).toList();
    boolean pulleys = wanted.stream().anyMatch(child -> child.name().equals("pulley"));
    for (Element child : wanted) {
      stop(child).ifPresent(stops::add);
    }
    Optional<Element> plane = element.child("plane");
    boolean isSum = sumAlone && wanted.isEmpty() && !element.children("term").isEmpty();
    if (!isSum && !isPossible(element, wanted, pulleys, plane.isPresent())) {
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
    if (stops.size() < wanted.size() || more.isEmpty() || (plane.isPresent() && frame.isEmpty())) {
      return Optional.empty();
    }
    List<Expression> changes = new ArrayList<>();
    Expression length = alongStops(frame, stops, changes);
    return Optional.of(
        new Rope(
            isSum ? more.get() : RelationReader.plus(more.get(), length),
            stops.stream()
                .filter(stop -> stop.isEye() || stop.isPulley())
                .map(Stop::centre)
                .toList(),
            changes));
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

  private boolean isPossible(Element element, List<Element> stops, boolean pulleys, boolean plane) {
    if (stops.size() < 2
        || !stops.get(0).name().equals("via")
        || !stops.get(stops.size() - 1).name().equals("via")) {
      relations.report(element, "a rope begins and ends at a via; write a via at both ends");
      return false;
    }
    for (int i = 1; i < stops.size() - 1; i++) {
      boolean between =
          stops.get(i - 1).name().equals("via") && stops.get(i + 1).name().equals("via");
      String name = stops.get(i).name();
      if (!between && (name.equals("around") || name.equals("branch"))) {
        relations.report(
            stops.get(i),
            name.equals("around")
                ? "it stands between two vias; write one before it and one behind it"
                : "a rope ends before it and begins anew behind it; write a via on both sides");
        return false;
      }
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
    if (element.name().equals("branch")) {
      return formulas.positive(element, "share", Quantity.NUMBER).map(RopeReader::branch);
    }
    Optional<BodyPoint> centre = names.point(element);
    if (element.name().equals("via")) {
      return centre.map(Stop::eye);
    }
    Optional<Expression> radius = formulas.positive(element, "radius", Quantity.LENGTH);
    if (element.name().equals("around")) {
      return centre.isPresent() && radius.isPresent()
          ? shape(element, centre.get(), radius.get())
          : Optional.empty();
    }
    Optional<Expression> turns = formulas.notNegative(element, "turns", Quantity.NUMBER);
    boolean left = element.required("side").equals("left");
    return centre.isPresent() && radius.isPresent() && turns.isPresent()
        ? Optional.of(
            new Stop(
                centre.get(),
                left ? radius.get() : new Negation(radius.get()),
                radius.get(),
                turns.get(),
                Optional.empty(),
                Optional.empty()))
        : Optional.empty();
  }

  private static Stop branch(Expression share) {
    return new Stop(
        new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
        Expression.ZERO,
        Expression.ZERO,
        Expression.ZERO,
        Optional.empty(),
        Optional.of(share));
  }

  private Optional<Stop> shape(Element element, BodyPoint centre, Expression radius) {
    boolean inside = element.attribute("inside").orElse("false").equals("true");
    Optional<Element> sideElement = element.child("side");
    Optional<BodyPoint> side = sideElement.flatMap(names::point);
    Optional<Vector3> axis =
        element.attribute("vector").isPresent()
            ? frames.direction(element, "the axis of the cylinder")
            : Optional.empty();
    Optional<Expression> tolerance = formulas.notNegative(element, "tolerance", Quantity.NUMBER);
    if (inside && sideElement.isPresent()) {
      relations.report(element, "it has inside and a side; leave one of them out");
      return Optional.empty();
    }
    if (!inside && element.attribute("tolerance").isPresent()) {
      relations.report(element, "tolerance has no meaning without inside=\"true\"; leave it out");
      return Optional.empty();
    }
    if (tolerance.isPresent() && !(tolerance.get() instanceof Expression.Constant)) {
      relations.report(element, "tolerance depends on a tunable parameter; write a number");
      return Optional.empty();
    }
    if (tolerance.isEmpty()
        || (sideElement.isPresent() && side.isEmpty())
        || (element.attribute("vector").isPresent() && axis.isEmpty())) {
      return Optional.empty();
    }
    WrapSection.Shape shape =
        new WrapSection.Shape(
            centre,
            axis.map(n -> n.times(1 / n.norm())),
            radius,
            side,
            inside,
            ((Expression.Constant) tolerance.get()).value());
    return Optional.of(
        new Stop(
            centre,
            Expression.ZERO,
            Expression.ZERO,
            Expression.ZERO,
            Optional.of(shape),
            Optional.empty()));
  }

  /** Returns the length; adds the formulas that tell where its form changes. */
  private static Expression alongStops(
      Optional<BodyFrame> plane, List<Stop> stops, List<Expression> changes) {
    Expression length = Expression.ZERO;
    Optional<Expression> share = Optional.empty();
    int from = 0;
    for (int i = 1; i < stops.size(); i++) {
      if (stops.get(i).share().isPresent()) {
        share = stops.get(i).share();
        from = i + 1;
      } else if (stops.get(i).isEye() && i > from) {
        Expression part = section(plane, stops.subList(from, i + 1), changes);
        Expression counted = share.isPresent() ? new Product(share.get(), part) : part;
        length = RelationReader.plus(length, counted);
        from = i;
      }
    }
    return length;
  }

  /** Returns the length from an eye to the next. */
  private static Expression section(
      Optional<BodyFrame> plane, List<Stop> stops, List<Expression> changes) {
    Stop first = stops.get(0);
    Stop last = stops.get(stops.size() - 1);
    Optional<WrapSection.Shape> shape = stops.get(1).shape();
    if (shape.isPresent()) {
      WrapSection wrap = new WrapSection(first.centre(), shape.get(), last.centre());
      changes.addAll(wrap.changes());
      return wrap.length();
    } else if (plane.isPresent()) {
      Expression length = new RopeSection(plane.get(), stops).length();
      changes.add(length);
      return length;
    }
    Expression squares = Expression.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      Expression way =
          minus(new PointPosition(last.centre(), axis), new PointPosition(first.centre(), axis));
      squares = RelationReader.plus(squares, new Product(way, way));
    }
    return root(squares);
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
