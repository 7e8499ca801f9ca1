package org.mechservice.mechml;

import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;

/** Sums the derivatives of forces, as one list of numbers. Unmoving bodies do not count. */
final class CollectedJacobian implements ForceJacobian {
  private final int links;
  private final int velocities;
  private final double[] numbers;

  CollectedJacobian(TreeGeometry tree) {
    links = tree.linkCount;
    velocities = tree.velocityCount;
    int side = 6 * links + velocities;
    numbers = new double[2 * side * side];
  }

  double[] numbers() {
    return numbers;
  }

  private void add(int row, int column, double byPlace, double byVelocity) {
    int at = 2 * (row * (6 * links + velocities) + column);
    numbers[at] += byPlace;
    numbers[at + 1] += byVelocity;
  }

  @Override
  public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int i = 0; i < 36 && on >= 0 && by >= 0; i++) {
      add(6 * on + i / 6, 6 * by + i % 6, byPlace[i], byVelocity[i]);
    }
  }

  @Override
  public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int i = 0; i < 6 && on >= 0; i++) {
      add(6 * on + i, 6 * links + by, byPlace[i], byVelocity[i]);
    }
  }

  @Override
  public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int i = 0; i < 6 && by >= 0; i++) {
      add(6 * links + on, 6 * by + i, byPlace[i], byVelocity[i]);
    }
  }

  @Override
  public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
    add(6 * links + on, 6 * links + by, byPlace, byVelocity);
  }
}
