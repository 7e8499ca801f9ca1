package org.mechservice.solver.force.formula;

import java.util.function.IntConsumer;
import org.mechservice.solver.expression.Expression.ClosestStation;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.force.law.ClosestPoint;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The abscissa of the point of a curve that is closest to a frame, m; it is found by a search and
 * has no derivatives.
 */
final class StationInput extends LeafInput {
  private final LeafInput along;
  private final LeafInput above;
  private final ClosestPoint point;
  private final double[] parameters;

  StationInput(TreeMotion motion, ClosestStation closest, double[] parameters) {
    along = new RelativeInput(motion, closest.along());
    above = new RelativeInput(motion, closest.above());
    point = new ClosestPoint(closest.curve());
    this.parameters = parameters;
  }

  @Override
  double value(double t) {
    point.parameters(parameters);
    point.find(along.value(t), above.value(t));
    return point.station();
  }

  @Override
  public void gradient(GradientSink sink) {}

  @Override
  public void links(IntConsumer taker) {
    along.links(taker);
  }
}
