package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A point of one body stays in a plane fixed in another.
 *
 * @param name name in the model file
 * @param point the point
 * @param plane a point of the plane on the body that carries it
 * @param normal unit vector normal to the plane, in the axes of the body that carries it
 * @param origin position in the model file
 */
public record PointOnPlaneClosure(
    String name, BodyPoint point, BodyPoint plane, Vector3 normal, Origin origin)
    implements LoopClosure {}
