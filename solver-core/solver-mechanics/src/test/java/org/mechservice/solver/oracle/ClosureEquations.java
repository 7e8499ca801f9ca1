package org.mechservice.solver.oracle;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.spatial.Vector3;

/** What closures set to zero, written from docs/mechml.md#joints and docs/mechml.md#constraints. */
final class ClosureEquations {
  private ClosureEquations() {}

  /**
   * Returns the left sides of a closure's equations.
   *
   * @param pose the pose of each body, and of the root at −1
   */
  static List<Taylor> conditions(LoopClosure closure, IntFunction<TaylorPose> pose) {
    if (closure instanceof JointClosure cut) {
      JointSide side = JointSide.of(cut.joint());
      TaylorPose relative = side.relative(pose.apply(side.body1()), pose.apply(side.body2()));
      return JointEquations.conditions(cut.joint(), relative);
    }
    if (closure instanceof DistanceClosure distance) {
      TaylorVector r = at(distance.point2(), pose).minus(at(distance.point1(), pose));
      return List.of(r.dot(r).minus(Taylor.of(distance.distance() * distance.distance())));
    }
    if (closure instanceof PointOnPlaneClosure plane) {
      TaylorVector r = at(plane.point(), pose).minus(at(plane.plane(), pose));
      return List.of(r.dot(pose.apply(plane.plane().body()).rotation().apply(plane.normal())));
    }
    if (closure instanceof PointOnLineClosure line) {
      TaylorVector r = at(line.point(), pose).minus(at(line.line(), pose));
      TaylorRotation axes = pose.apply(line.line().body()).rotation();
      Vector3 b = JointEquations.normalTo(line.direction());
      return List.of(r.dot(axes.apply(b)), r.dot(axes.apply(line.direction().cross(b))));
    }
    throw new IllegalArgumentException("the oracle has no equations for " + closure);
  }

  /** Returns the bodies, root left out, that a closure's equations depend on. */
  static List<Integer> bodies(LoopClosure closure) {
    List<Integer> bodies = new ArrayList<>();
    if (closure instanceof JointClosure cut) {
      bodies.add(cut.joint().attachment().parent());
      bodies.add(cut.joint().attachment().child());
    } else if (closure instanceof DistanceClosure distance) {
      bodies.add(distance.point1().body());
      bodies.add(distance.point2().body());
    } else if (closure instanceof PointOnPlaneClosure plane) {
      bodies.add(plane.point().body());
      bodies.add(plane.plane().body());
    } else if (closure instanceof PointOnLineClosure line) {
      bodies.add(line.point().body());
      bodies.add(line.line().body());
    }
    bodies.removeIf(body -> body == BodyPoint.ROOT);
    return bodies;
  }

  static TaylorVector at(BodyPoint point, IntFunction<TaylorPose> pose) {
    return pose.apply(point.body()).at(point.position());
  }
}
