package org.mechservice.solver.mechanism.joint;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.JointType;

/**
 * Start values of the coordinates of a joint with several of them, in the order of
 * docs/mechml.md#joints.
 *
 * @param positions rad, m, or Euler parameters (scalar first, norm 1)
 * @param velocities rad/s or m/s
 */
public record JointStart(List<Double> positions, List<Double> velocities) {
  public JointStart {
    positions = List.copyOf(positions);
    velocities = List.copyOf(velocities);
  }

  /** Returns the start at zero, at rest; Euler parameters are 1, 0, 0, 0. */
  public static JointStart atZero(JointType type) {
    Double[] positions = new Double[type.positionCount()];
    Double[] velocities = new Double[type.velocityCount()];
    Arrays.fill(positions, 0.0);
    Arrays.fill(velocities, 0.0);
    if (type == JointType.S || type == JointType.F) {
      positions[0] = 1.0;
    }
    return new JointStart(List.of(positions), List.of(velocities));
  }

  /**
   * Rejects a start with a wrong number of values.
   *
   * @throws IllegalArgumentException naming the joint and both numbers
   */
  void requireCounts(String joint, JointType type) {
    if (positions.size() != type.positionCount() || velocities.size() != type.velocityCount()) {
      throw new IllegalArgumentException(
          "joint "
              + joint
              + " starts with "
              + positions.size()
              + " positions and "
              + velocities.size()
              + " velocities; type "
              + type
              + " has "
              + type.positionCount()
              + " and "
              + type.velocityCount());
    }
  }

  void writePositions(double[] q, int offset) {
    for (int i = 0; i < positions.size(); i++) {
      q[offset + i] = positions.get(i);
    }
  }

  void writeVelocities(double[] v, int offset) {
    for (int i = 0; i < velocities.size(); i++) {
      v[offset + i] = velocities.get(i);
    }
  }
}
