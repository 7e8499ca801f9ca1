package org.mechservice.solver.expression;

/**
 * A coordinate of a joint of the tree.
 *
 * @param joint index among the mechanism's joints
 * @param component which of the joint's coordinates, from 0
 */
public record JointCoordinate(int joint, int component) implements Coordinate {}
