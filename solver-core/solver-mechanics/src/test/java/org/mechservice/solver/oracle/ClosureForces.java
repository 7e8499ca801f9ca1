package org.mechservice.solver.oracle;

import java.util.function.IntFunction;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.spatial.Vector3;

/** What rods, planes and lines exert by their multipliers, which oppose growing residuals. */
public final class ClosureForces {
  private ClosureForces() {}

  /**
   * Adds the forces of a closure that is no joint.
   *
   * @param multipliers λ, N, from {@code at}
   */
  public static void apply(
      LoopClosure closure,
      double[] multipliers,
      int at,
      IntFunction<TaylorPose> pose,
      OracleForce.Loads loads) {
    if (closure instanceof DistanceClosure rod) {
      Vector3 way = place(pose, rod.point2()).minus(place(pose, rod.point1()));
      pull(rod.point1(), rod.point2(), way.normalized().times(multipliers[at]), pose, loads);
    } else if (closure instanceof PointOnPlaneClosure plane) {
      Vector3 normal = plane.normal().times(multipliers[at]);
      pull(plane.plane(), plane.point(), inWorld(pose, plane.plane(), normal), pose, loads);
    } else if (closure instanceof PointOnLineClosure line) {
      Vector3 b = JointEquations.normalTo(line.direction());
      Vector3 across =
          b.times(multipliers[at]).plus(line.direction().cross(b).times(multipliers[at + 1]));
      pull(line.line(), line.point(), inWorld(pose, line.line(), across), pose, loads);
    }
  }

  private static Vector3 inWorld(IntFunction<TaylorPose> pose, BodyPoint point, Vector3 v) {
    return pose.apply(point.body()).rotation().value().apply(v);
  }

  private static Vector3 place(IntFunction<TaylorPose> pose, BodyPoint point) {
    return pose.apply(point.body()).at(point.position()).value();
  }

  /** A force on one body and the opposite on another, both at the same place. */
  public static void pull(
      BodyPoint first,
      BodyPoint second,
      Vector3 onFirst,
      IntFunction<TaylorPose> pose,
      OracleForce.Loads loads) {
    loads.force(second, onFirst.negated());
    TaylorPose body = pose.apply(first.body());
    Vector3 there = place(pose, second).minus(body.position().value());
    loads.force(
        new BodyPoint(first.body(), body.rotation().transposed().value().apply(there)), onFirst);
  }
}
