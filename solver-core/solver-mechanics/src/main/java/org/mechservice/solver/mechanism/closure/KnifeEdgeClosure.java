package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A point of one body has no velocity sideways, relative to another body, as the edge of a skate or
 * of a knife has: one equation of velocities, which is not the derivative of an equation of
 * positions.
 *
 * @param name name in the model file
 * @param ground a point of the body relative to which the edge moves
 * @param point the point of the edge
 * @param side unit vector across the edge, in the axes of the body that carries the edge
 * @param origin position in the model file
 */
public record KnifeEdgeClosure(
    String name, BodyPoint ground, BodyPoint point, Vector3 side, Origin origin)
    implements LoopClosure {}
