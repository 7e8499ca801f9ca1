package org.mechservice.solver.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.spatial.Vector3;

/** The size of a mechanism: what a residual in m is compared with. */
final class LengthScale {
  private LengthScale() {}

  /**
   * Returns the largest distance between points of one body that joints, closures or centres of
   * mass name, m; 1 if all coincide. What hangs on the root is measured between its ends on moving
   * bodies alone, since the place in the world does not matter.
   */
  static double of(TreeGeometry tree) {
    double largest = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        largest = Math.max(largest, norm(tree.offset, 3 * link));
      }
      largest = Math.max(largest, norm(tree.centerOfMass, 3 * link));
    }
    for (LoopClosure closure : tree.mechanism().closures()) {
      largest = Math.max(largest, of(closure, tree));
    }
    return largest > 0 ? largest : 1;
  }

  private static double of(LoopClosure closure, TreeGeometry tree) {
    if (closure instanceof DistanceClosure distance) {
      return Math.max(
          distance.distance(),
          Math.max(arm(distance.point1(), tree), arm(distance.point2(), tree)));
    } else if (closure instanceof JointClosure joint) {
      var at = joint.joint().attachment();
      return Math.max(
          arm(new BodyPoint(at.parent(), at.parentPoint()), tree),
          arm(new BodyPoint(at.child(), at.childPoint()), tree));
    } else if (closure instanceof PointOnPlaneClosure plane) {
      return Math.max(arm(plane.point(), tree), arm(plane.plane(), tree));
    } else if (closure instanceof PointOnLineClosure line) {
      return Math.max(arm(line.point(), tree), arm(line.line(), tree));
    }
    return 0;
  }

  private static double arm(BodyPoint point, TreeGeometry tree) {
    if (point.body() == BodyPoint.ROOT) {
      return 0;
    }
    double[] r = new double[3];
    tree.fromReference(point, r, 0);
    return norm(r, 0);
  }

  private static double norm(double[] v, int at) {
    return new Vector3(v[at], v[at + 1], v[at + 2]).norm();
  }
}
