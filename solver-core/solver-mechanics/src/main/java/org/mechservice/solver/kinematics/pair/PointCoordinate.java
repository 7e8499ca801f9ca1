package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A world coordinate of a point of a body as a function of the body's pose relative to the root:
 * the displacement of the point from the world's origin along an axis of the world.
 *
 * @param origin the world's origin as a point of the root
 * @param relative the point's motion relative to the root
 * @param function the coordinate, m
 */
public record PointCoordinate(BodyPoint origin, RelativeMotion relative, PairFunction function) {
  private static final Vector3[] AXES = {
    new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)
  };

  /** Returns the coordinate of a point of a tree. */
  public static PointCoordinate of(TreeGeometry tree, PointPosition position) {
    Root root = tree.mechanism().root();
    Rotation toRoot = root.orientation().transposed();
    BodyPoint origin = new BodyPoint(BodyPoint.ROOT, toRoot.apply(root.position()).times(-1));
    Vector3 axis = toRoot.apply(AXES[position.axis()]);
    return new PointCoordinate(
        origin,
        new RelativeMotion(tree, origin, position.point()),
        PairFunction.displacement("coordinate of a point", axis));
  }
}
