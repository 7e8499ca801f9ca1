package org.mechservice.solver.closure.equations;

import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.spatial.Vector3;

/** The length scale of a mechanism, for relative residuals. */
final class LengthScale {
  private LengthScale() {}

  /**
   * Returns the largest distance between points of one body that joints, closures or centres of
   * mass name, m; 1 if all coincide. Connections to the root are measured only between their ends
   * on moving bodies, since the position in the world does not matter.
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

  /**
   * Returns the largest distance from the root's origin of a point on the root that a joint or
   * closure names, m. It determines the rounding errors of computed positions.
   */
  static double farthest(TreeGeometry tree) {
    double largest = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.parent[link] == TreeGeometry.ROOT) {
        largest = Math.max(largest, norm(tree.offset, 3 * link));
      }
    }
    for (LoopClosure closure : tree.mechanism().closures()) {
      for (BodyPoint point : points(closure)) {
        boolean fixed = point.body() == BodyPoint.ROOT;
        largest = Math.max(largest, fixed ? point.position().norm() : 0);
      }
    }
    return largest;
  }

  /** Returns the length of a way through links, from one reference point to the next, m. */
  static double reach(TreeGeometry tree, int[] links) {
    double sum = 0;
    for (int link : links) {
      sum += tree.parent[link] == TreeGeometry.ROOT ? 0 : norm(tree.offset, 3 * link);
    }
    return sum;
  }

  private static double of(LoopClosure closure, TreeGeometry tree) {
    double largest = 0;
    if (closure instanceof DistanceClosure rod) {
      largest = rod.distance();
    } else if (closure instanceof RollingClosure rolling) {
      largest = rolling.size();
    }
    for (BodyPoint point : points(closure)) {
      largest = Math.max(largest, arm(point, tree));
    }
    return largest;
  }

  private static List<BodyPoint> points(LoopClosure closure) {
    if (closure instanceof DistanceClosure distance) {
      return List.of(distance.point1(), distance.point2());
    } else if (closure instanceof JointClosure joint) {
      var at = joint.joint().attachment();
      return List.of(
          new BodyPoint(at.parent(), at.parentPoint()), new BodyPoint(at.child(), at.childPoint()));
    } else if (closure instanceof PointOnPlaneClosure plane) {
      return List.of(plane.point(), plane.plane());
    } else if (closure instanceof PointOnLineClosure line) {
      return List.of(line.point(), line.line());
    } else if (closure instanceof RollingClosure rolling) {
      return List.of(rolling.centre(), rolling.plane());
    } else if (closure instanceof KnifeEdgeClosure edge) {
      return List.of(edge.point(), edge.ground());
    }
    return List.of();
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
