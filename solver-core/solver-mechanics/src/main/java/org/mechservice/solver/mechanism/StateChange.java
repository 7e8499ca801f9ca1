package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.expression.Expression;

/**
 * New values of a joint's coordinates.
 *
 * @param joint index among the mechanism's joints; it is not driven
 * @param positions one expression of the previous state per position, rad, m or Euler parameters;
 *     empty if they do not change
 * @param velocities one expression of the previous state per velocity, rad/s or m/s; empty if they
 *     do not change
 */
public record StateChange(int joint, List<Expression> positions, List<Expression> velocities) {
  public StateChange {
    positions = List.copyOf(positions);
    velocities = List.copyOf(velocities);
  }
}
