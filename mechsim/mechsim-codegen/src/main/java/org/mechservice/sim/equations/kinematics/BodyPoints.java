package org.mechservice.sim.equations.kinematics;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.links.BodyPlacement;
import org.mechservice.solver.links.ComputingAxes;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Points and axes of bodies in the computing frames of the links that carry them. */
public final class BodyPoints {
  private final Expressions expressions;
  private final Links mechanism;

  public BodyPoints(Expressions expressions, Links mechanism) {
    this.expressions = expressions;
    this.mechanism = mechanism;
  }

  /** Returns the link that carries a body, or the root. */
  public int link(int body) {
    return body == BodyPoint.ROOT ? Links.ROOT : mechanism.bodies().get(body).link();
  }

  /** Returns a point from the link's computing origin, in its computing axes, m. */
  public ScalarVector inLink(BodyPoint point) {
    return ScalarVector.of(expressions, place(mechanism, point));
  }

  /** Returns the constant position of a point in its link. */
  public static Vector3 place(Links mechanism, BodyPoint point) {
    if (point.body() == BodyPoint.ROOT) {
      return point.position();
    }
    BodyPlacement place = mechanism.bodies().get(point.body());
    Vector3 r = ComputingAxes.inFrame(place.toFrame(), point.position());
    return place.origin().plus(r);
  }

  /** Returns a constant rotation from axes fixed in a body to the link's computing axes. */
  public ScalarMatrix axes(int body, Rotation toBody) {
    Rotation rotation =
        body == BodyPoint.ROOT
            ? toBody
            : Axes.snapped(mechanism.bodies().get(body).toFrame().times(toBody));
    double[][] elements = Axes.elements(rotation);
    return ScalarMatrix.of((i, j) -> expressions.constant(elements[i][j]));
  }
}
