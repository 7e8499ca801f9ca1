package org.mechservice.solver.mechanism.force;

import org.mechservice.solver.expression.BodyPoint;

/**
 * A point of the model file by its name.
 *
 * @param body name of its body or of the root
 * @param name name of the point
 * @param point its position
 */
public record NamedPoint(String body, String name, BodyPoint point) {}
