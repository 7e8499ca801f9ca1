package org.mechservice.solver.expression;

/**
 * A coordinate of a cut joint: not a state, but computed from the pose of the two bodies it joins.
 *
 * @param closure index among the mechanism's closures, which must be a joint
 * @param component which of the joint's coordinates, from 0
 */
public record ClosureCoordinate(int closure, int component) implements Coordinate {}
