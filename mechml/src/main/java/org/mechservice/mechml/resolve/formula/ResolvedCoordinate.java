package org.mechservice.mechml.resolve.formula;

import org.mechservice.solver.expression.Coordinate;

/**
 * A coordinate of a joint.
 *
 * @param joint the joint
 * @param component index among the joint's positions or velocities, from 0
 * @param turns whether its velocity is angular
 */
public record ResolvedCoordinate(ResolvedJoint joint, int component, boolean turns) {
  public Coordinate coordinate() {
    return joint.coordinate(component);
  }
}
