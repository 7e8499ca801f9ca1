package org.mechservice.mechml;

import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;

/**
 * The surface of a contact or a tyre whose height changes, for pictures.
 *
 * @param frame its axes: the height changes along x and is counted along z
 * @param height of {@link Expression.Argument}, which is x, and parameters, m
 */
public record Road(BodyFrame frame, Expression height) {}
