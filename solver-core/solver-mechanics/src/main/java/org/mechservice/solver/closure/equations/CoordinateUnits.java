package org.mechservice.solver.closure.equations;

import java.util.Arrays;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Units that make coordinates of the state comparable: displacements are divided by a length of the
 * mechanism; angles and Euler parameters are not scaled.
 */
public final class CoordinateUnits {
  /** Unit of each position, m or 1. */
  public final double[] positions;

  /** Unit of each velocity, m or 1 per second. */
  public final double[] velocities;

  /**
   * @param length of the mechanism, m
   */
  public CoordinateUnits(Mechanism mechanism, double length) {
    positions = new double[mechanism.positionCount()];
    velocities = new double[mechanism.velocityCount()];
    Arrays.fill(positions, 1);
    Arrays.fill(velocities, 1);
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        continue;
      }
      JointType type = mechanism.joints().get(j).type();
      for (int i = 0; i < type.positionCount(); i++) {
        if (type.positionUnit(i).equals("m")) {
          positions[mechanism.positionOffset(j) + i] = length;
        }
      }
      for (int i = 0; i < type.velocityCount(); i++) {
        if (type.velocityUnit(i).equals("m/s")) {
          velocities[mechanism.velocityOffset(j) + i] = length;
        }
      }
    }
  }

  /** Returns the largest scaled velocity of a state, 1/s. */
  public double speed(double[] y, int velocityAt) {
    double speed = 0;
    for (int j = 0; j < velocities.length; j++) {
      speed = Math.max(speed, Math.abs(y[velocityAt + j]) / velocities[j]);
    }
    return speed;
  }
}
