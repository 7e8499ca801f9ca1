package org.mechservice.sim.equations;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.ScalarMatrix;
import org.mechservice.sim.symbolic.ScalarVector;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Points and axes of bodies in the computing frames of the links that carry them. */
final class BodyPoints {
  private final Expressions expressions;
  private final Links mechanism;

  BodyPoints(Expressions expressions, Links mechanism) {
    this.expressions = expressions;
    this.mechanism = mechanism;
  }

  /** Returns the link that carries a body, or the root. */
  int link(int body) {
    return body == BodyPoint.ROOT ? Links.ROOT : mechanism.bodies().get(body).link();
  }

  /** Returns a point from the link's computing origin, in its computing axes, m. */
  ScalarVector inLink(BodyPoint point) {
    return ScalarVector.of(expressions, place(mechanism, point));
  }

  /** Returns the same as numbers. */
  static Vector3 place(Links mechanism, BodyPoint point) {
    if (point.body() == BodyPoint.ROOT) {
      return point.position();
    }
    BodyPlace place = mechanism.bodies().get(point.body());
    Vector3 r = ComputingAxes.inFrame(place.toFrame(), point.position());
    return place.origin().plus(r);
  }

  /** Returns a constant rotation from axes fixed in a body to the link's computing axes. */
  ScalarMatrix axes(int body, Rotation toBody) {
    Rotation rotation =
        body == BodyPoint.ROOT
            ? toBody
            : Axes.snapped(mechanism.bodies().get(body).toFrame().times(toBody));
    double[][] elements = Axes.elements(rotation);
    return ScalarMatrix.of((i, j) -> expressions.constant(elements[i][j]));
  }
}
