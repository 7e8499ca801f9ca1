package org.mechservice.sim.equations.coordinates;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** Formulas of time, parameters and the state as scalars; parameters are inputs. */
public final class StateFormulas extends Formulas {
  /** Placeholder for the length of a path, far below those of the positions of a relation. */
  private static final int PATH = Integer.MIN_VALUE + 1;

  private final Expressions expressions;
  private final JointCoordinates joints;
  private final BodyPoints points;
  private final LinkKinematics kinematics;
  private final int firstState;
  private final Map<List<BodyFrame>, RelativeFrameMotion> motions = new HashMap<>();

  /**
   * @param firstState input of the first further state
   */
  public StateFormulas(
      Expressions expressions,
      JointCoordinates joints,
      BodyPoints points,
      LinkKinematics kinematics,
      int firstState) {
    super(expressions);
    this.expressions = expressions;
    this.firstState = firstState;
    this.joints = joints;
    this.points = points;
    this.kinematics = kinematics;
  }

  @Override
  protected Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.CoordinatePosition position) {
      return joints.position(position.coordinate());
    } else if (leaf instanceof Expression.StateValue state) {
      return expressions.input(firstState + state.index());
    } else if (leaf instanceof Expression.CoordinateVelocity velocity) {
      return joints.velocity(velocity.coordinate());
    } else if (leaf instanceof Expression.PointPosition point) {
      return place(point.point()).at(point.axis());
    } else if (leaf instanceof Expression.PointVelocity point) {
      return speed(point.point()).at(point.axis());
    } else if (leaf instanceof PathMotion motion) {
      return pathMotion(motion);
    } else if (leaf instanceof Expression.RelativeMotion relative) {
      return motions
          .computeIfAbsent(List.of(relative.frame1(), relative.frame2()), this::motion)
          .component(relative.component());
    } else if (leaf instanceof Expression.ClosestStation closest) {
      return ClosestPointSearch.station(
          ClosestPointSearch.Curve.of(expressions, closest.curve()),
          leaf(closest.along()),
          leaf(closest.above()));
    }
    throw new IllegalArgumentException(leaf + " has no value in a force");
  }

  /** Returns the placeholder for the motion of a path, which the force along it replaces. */
  public Scalar pathMotion(PathMotion motion) {
    return expressions.input(PATH - (motion.isRate() ? 1 : 0));
  }

  /** Returns the motion of a second frame relative to a first. */
  private RelativeFrameMotion motion(List<BodyFrame> frames) {
    return new RelativeFrameMotion(kinematics, points, frames.get(0), frames.get(1));
  }

  private ScalarVector place(BodyPoint point) {
    return kinematics.placeInWorld(points.link(point.body()), points.inLink(point));
  }

  private ScalarVector speed(BodyPoint point) {
    int link = points.link(point.body());
    return kinematics.toWorld(link, kinematics.velocityAt(link, points.inLink(point)));
  }
}
