package org.mechservice.solver.kinematics;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Offsets of each joint's coordinates in the extended q and v; those of driven joints come last.
 */
final class ExtendedOffsets {
  private final int[] position;
  private final int[] velocity;
  private int positionCount;
  private int velocityCount;

  ExtendedOffsets(Mechanism mechanism) {
    int joints = mechanism.joints().size();
    position = new int[joints];
    velocity = new int[joints];
    positionCount = mechanism.positionCount();
    velocityCount = mechanism.velocityCount();
    for (int j = 0; j < joints; j++) {
      position[j] = mechanism.positionOffset(j);
      velocity[j] = mechanism.velocityOffset(j);
      if (mechanism.isDriven(j)) {
        JointType type = mechanism.joints().get(j).type();
        position[j] = positionCount;
        velocity[j] = velocityCount;
        positionCount += type.positionCount();
        velocityCount += type.velocityCount();
      }
    }
  }

  int position(int joint) {
    return position[joint];
  }

  int velocity(int joint) {
    return velocity[joint];
  }

  int positionCount() {
    return positionCount;
  }

  int velocityCount() {
    return velocityCount;
  }
}
