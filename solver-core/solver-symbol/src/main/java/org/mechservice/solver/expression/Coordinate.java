package org.mechservice.solver.expression;

/**
 * One coordinate of a joint: a position and the velocity, force and power that belong to it.
 *
 * <p>The component of a position is an index among the joint's positions; that of a velocity or a
 * force is an index among its velocities (docs/mechml.md#joints). The two differ only in joints
 * with Euler parameters.
 */
public sealed interface Coordinate permits JointCoordinate, ClosureCoordinate {
  /** Returns the component of the joint, from 0. */
  int component();
}
