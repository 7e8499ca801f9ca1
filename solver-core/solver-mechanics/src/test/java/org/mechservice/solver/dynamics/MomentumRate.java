package org.mechservice.solver.dynamics;

import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * How the momentum of all bodies changes, and their moment of momentum about the world's origin:
 * once by the accelerations, once by the weights. Six numbers in world axes, [N·m; N].
 */
final class MomentumRate {
  private final double[] ofMotion = new double[6];
  private final double[] ofWeight = new double[6];
  private double scale = 1;

  /**
   * @param motion after both sweeps
   */
  MomentumRate(TreeMotion motion) {
    TreeGeometry tree = motion.tree();
    for (int link = 0; link < tree.linkCount; link++) {
      add(motion, tree, link);
    }
  }

  private void add(TreeMotion motion, TreeGeometry tree, int link) {
    double m = tree.mass[link];
    double[] c = new double[3];
    double[] a = new double[3];
    double[] h = new double[3];
    motion.points.position(link, tree.centerOfMass, 3 * link, c, 0);
    motion.points.acceleration(link, tree.centerOfMass, 3 * link, a, 0);
    motion.toWorld(link, spinRate(motion, tree, link), 0, h, 0);
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      double inertial = m * (c[j] * a[k] - c[k] * a[j]) + h[i];
      ofMotion[i] += inertial;
      ofMotion[3 + i] += m * a[i];
      ofWeight[i] += m * (c[j] * tree.gravity[k] - c[k] * tree.gravity[j]);
      ofWeight[3 + i] += m * tree.gravity[i];
      scale += Math.abs(inertial) + m * Math.abs(a[i]);
    }
  }

  /** I α + ω × I ω about the centre of mass, in link axes. */
  private static double[] spinRate(TreeMotion motion, TreeGeometry tree, int link) {
    double[] alpha = inertiaTimes(tree, link, motion.angularAcceleration);
    double[] spin = inertiaTimes(tree, link, motion.angularVelocity);
    double[] w = motion.angularVelocity;
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      alpha[i] += w[3 * link + j] * spin[k] - w[3 * link + k] * spin[j];
    }
    return alpha;
  }

  private static double[] inertiaTimes(TreeGeometry tree, int link, double[] vector) {
    double[] i = tree.inertia;
    int at = 6 * link;
    double x = vector[3 * link];
    double y = vector[3 * link + 1];
    double z = vector[3 * link + 2];
    return new double[] {
      i[at] * x + i[at + 3] * y + i[at + 4] * z,
      i[at + 3] * x + i[at + 1] * y + i[at + 5] * z,
      i[at + 4] * x + i[at + 5] * y + i[at + 2] * z
    };
  }

  double[] ofMotion() {
    return ofMotion;
  }

  double[] ofWeight() {
    return ofWeight;
  }

  /** Returns the sum of the sizes of what was added up. */
  double scale() {
    return scale;
  }
}
