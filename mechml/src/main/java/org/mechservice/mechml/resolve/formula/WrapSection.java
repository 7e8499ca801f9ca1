package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.ScalarFormulas;
import org.mechservice.solver.force.law.Wrap;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** A path from one eye over a sphere or a cylinder to the next: its length as a formula. */
final class WrapSection {
  private static final List<Vector3> AXES =
      List.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));

  /**
   * A sphere or a cylinder without ends.
   *
   * @param centre of the sphere, or a point of the axis
   * @param axis unit vector of the cylinder in its body; empty of a sphere
   * @param radius m
   * @param side a point on whose side the path passes
   * @param inside whether the path runs through it as through a ring
   * @param tolerance of the touching point inside, rad
   */
  record Shape(
      BodyPoint centre,
      Optional<Vector3> axis,
      Expression radius,
      Optional<BodyPoint> side,
      boolean inside,
      double tolerance) {}

  private final Expressions e = new Expressions();
  private final List<Expression> leaves = new ArrayList<>();
  private final ScalarFormulas formulas;
  private final Wrap.Way way;

  WrapSection(BodyPoint from, Shape shape, BodyPoint to) {
    ScalarVector centre = place(shape.centre());
    ScalarVector first = place(from).minus(centre);
    ScalarVector second = place(to).minus(centre);
    Optional<ScalarVector> axis = shape.axis().map(n -> direction(shape.centre(), n));
    Wrap wrap = new Wrap(e, first, second, axis, input(shape.radius()));
    if (shape.inside()) {
      way =
          wrap.inside(
              AXES.stream().map(one -> direction(shape.centre(), one)).toList(), shape.tolerance());
    } else {
      way =
          shape
              .side()
              .map(side -> wrap.beside(place(side).minus(centre)))
              .orElseGet(wrap::shortest);
    }
    formulas = new ScalarFormulas(leaves);
  }

  /** Returns the length, m. */
  Expression length() {
    return formulas.of(way.length());
  }

  /** Returns formulas that change where the form of the path changes, and nowhere else. */
  List<Expression> changes() {
    return way.margins().stream()
        .map(margin -> Expression.call(MathFunction.STEP, List.of(formulas.of(margin))))
        .toList();
  }

  private Scalar input(Expression leaf) {
    if (leaf instanceof Expression.Constant constant) {
      return e.constant(constant.value());
    }
    int known = leaves.indexOf(leaf);
    if (known >= 0) {
      return e.input(known);
    }
    leaves.add(leaf);
    return e.input(leaves.size() - 1);
  }

  private ScalarVector place(BodyPoint point) {
    return new ScalarVector(
        input(new PointPosition(point, 0)),
        input(new PointPosition(point, 1)),
        input(new PointPosition(point, 2)));
  }

  /** Returns a vector fixed in the body of a point, in world axes. */
  private ScalarVector direction(BodyPoint origin, Vector3 vector) {
    BodyPoint tip = new BodyPoint(origin.body(), origin.position().plus(vector));
    return place(tip).minus(place(origin));
  }
}
