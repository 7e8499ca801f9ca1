package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A point of one body stays on a straight line fixed in another.
 *
 * @param name name in the model file
 * @param point the point
 * @param line a point of the line on the body that carries it
 * @param direction unit vector along the line, in the axes of the body that carries it
 * @param origin position in the model file
 */
public record PointOnLineClosure(
    String name, BodyPoint point, BodyPoint line, Vector3 direction, Origin origin)
    implements LoopClosure {}
