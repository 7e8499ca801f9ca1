package org.mechservice.sim.build.dynamics;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;

/** Formulas of time, parameters and the state as scalars; parameters are inputs. */
final class StateFormulas extends Formulas {
  private final JointLinks joints;
  private final BodyPoints points;
  private final LinkKinematics kinematics;

  StateFormulas(
      Expressions expressions, JointLinks joints, BodyPoints points, LinkKinematics kinematics) {
    super(expressions);
    this.joints = joints;
    this.points = points;
    this.kinematics = kinematics;
  }

  @Override
  Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.CoordinatePosition position) {
      return joints.position(joint(position.coordinate()));
    } else if (leaf instanceof Expression.CoordinateVelocity velocity) {
      return joints.velocity(joint(velocity.coordinate()));
    } else if (leaf instanceof Expression.PointPosition point) {
      return place(point.point()).at(point.axis());
    } else if (leaf instanceof Expression.PointVelocity point) {
      return speed(point.point()).at(point.axis());
    }
    throw new IllegalArgumentException(leaf + " has no value in a force");
  }

  private static JointCoordinate joint(Coordinate coordinate) {
    if (coordinate instanceof JointCoordinate joint) {
      return joint;
    }
    throw new IllegalArgumentException("coordinates of cut joints are not generated");
  }

  private ScalarVector place(BodyPoint point) {
    return kinematics.placeInWorld(points.link(point.body()), points.inLink(point));
  }

  private ScalarVector speed(BodyPoint point) {
    int link = points.link(point.body());
    return kinematics.toWorld(link, kinematics.velocityAt(link, points.inLink(point)));
  }
}
