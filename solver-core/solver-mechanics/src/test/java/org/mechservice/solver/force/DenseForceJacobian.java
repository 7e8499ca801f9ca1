package org.mechservice.solver.force;

import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;

/** Gathers all derivatives and applies them to a change of the state. */
final class DenseForceJacobian implements ForceJacobian {
  private final TreeGeometry tree;
  private final int links;
  private final int n;

  /** Rows: 6 per link, then one per velocity; columns likewise. */
  private final double[][] place;

  private final double[][] velocity;

  DenseForceJacobian(TreeGeometry tree) {
    this.tree = tree;
    links = 6 * tree.linkCount;
    n = links + tree.velocityCount;
    place = new double[n][n];
    velocity = new double[n][n];
  }

  @Override
  public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        place[6 * on + i][6 * by + j] += byPlace[6 * i + j];
        velocity[6 * on + i][6 * by + j] += byVelocity[6 * i + j];
      }
    }
  }

  @Override
  public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int i = 0; i < 6; i++) {
      place[6 * on + i][links + by] += byPlace[i];
      velocity[6 * on + i][links + by] += byVelocity[i];
    }
  }

  @Override
  public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    for (int j = 0; j < 6; j++) {
      place[links + on][6 * by + j] += byPlace[j];
      velocity[links + on][6 * by + j] += byVelocity[j];
    }
  }

  @Override
  public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
    place[links + on][links + by] += byPlace;
    velocity[links + on][links + by] += byVelocity;
  }

  /**
   * Returns the change of all wrenches and joint forces.
   *
   * @param twist displacement twists of all links, then displacements of all coordinates
   * @param velocities changes of all velocity twists, then of all velocities
   */
  double[] change(double[] twist, double[] velocities) {
    double[] sum = new double[n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        sum[i] += place[i][j] * twist[j] + velocity[i][j] * velocities[j];
      }
    }
    return sum;
  }

  /** Returns whether an entry between two links is there. */
  boolean couples(int on, int by) {
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        if (place[6 * on + i][6 * by + j] != 0 || velocity[6 * on + i][6 * by + j] != 0) {
          return true;
        }
      }
    }
    return false;
  }

  TreeGeometry tree() {
    return tree;
  }
}
