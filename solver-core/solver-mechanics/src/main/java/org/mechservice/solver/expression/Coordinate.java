package org.mechservice.solver.expression;

/**
 * One coordinate of a joint: a position and the velocity, force and power that belong to it.
 *
 * <p>Where a position is meant, the component counts the joint's positions; where a velocity or a
 * force is meant, its velocities (MECHML §4). The two differ only in joints with Euler parameters.
 */
public sealed interface Coordinate permits JointCoordinate, ClosureCoordinate {
  /** Returns which component of the joint is meant, from 0. */
  int component();
}
