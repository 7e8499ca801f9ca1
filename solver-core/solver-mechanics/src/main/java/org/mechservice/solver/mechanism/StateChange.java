package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.expression.Expression;

/**
 * New values of a joint's coordinates.
 *
 * @param joint index among the mechanism's joints; it is not driven
 * @param positions one expression of the state before per position, rad, m or Euler parameters;
 *     empty if they stay
 * @param velocities one expression of the state before per velocity, rad/s or m/s; empty if they
 *     stay
 */
public record StateChange(int joint, List<Expression> positions, List<Expression> velocities) {
  public StateChange {
    positions = List.copyOf(positions);
    velocities = List.copyOf(velocities);
  }
}
