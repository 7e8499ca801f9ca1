package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;

/** Velocity and acceleration of each link from those of its parent. */
final class LinkMotion {
  private final TreeGeometry tree;
  private final double[] v;
  private final double[] a;
  private final double[] rotation;
  private final double[] position;
  private final double[] angularVelocity;
  private final double[] linearVelocity;
  private final double[] subspace;
  private final double[] relativeVelocity;
  private final double[] velocityProduct;
  private final double[] angularAcceleration;
  private final double[] linearAcceleration;
  private final double[] carried = new double[3];

  /** Writes to the arrays of a motion. */
  LinkMotion(TreeMotion motion) {
    tree = motion.tree();
    v = motion.v;
    a = motion.a;
    rotation = motion.rotation;
    position = motion.position;
    angularVelocity = motion.angularVelocity;
    linearVelocity = motion.linearVelocity;
    subspace = motion.subspace;
    relativeVelocity = motion.relativeVelocity;
    velocityProduct = motion.velocityProduct;
    angularAcceleration = motion.angularAcceleration;
    linearAcceleration = motion.linearAcceleration;
  }

  /** V = X V_p + S v: ω = Rᵀ ω_p + S_ω v, u = Rᵀ (u_p + ω_p × p) + S_u v; c = X V_p × S v. */
  void move(int link) {
    carry(angularVelocity, linearVelocity, link);
    switch (tree.kind[link]) {
      case TURN -> turn(link);
      case SLIDE -> slide(link);
      case SCREW, BALL -> moveAlongColumns(link);
      case FIXED -> {
        // relative velocity and velocity product stay zero
      }
    }
  }

  /**
   * Writes the velocity of the parent's material point at the link's reference point, in link axes:
   * ω = Rᵀ ω_p, u = Rᵀ (u_p + ω_p × p).
   */
  private void carry(double[] angular, double[] linear, int link) {
    int at = 3 * link;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      setZero(angular, at);
      setZero(linear, at);
      return;
    }
    applyTransposed(rotation, 9 * link, angular, 3 * parent, angular, at);
    System.arraycopy(linear, 3 * parent, carried, 0, 3);
    addCross(angular, 3 * parent, position, at, carried, 0);
    applyTransposed(rotation, 9 * link, carried, 0, linear, at);
  }

  private void turn(int link) {
    int at = 3 * link;
    double rate = v[tree.velocityAt[link]];
    for (int i = 0; i < 3; i++) {
      relativeVelocity[2 * at + i] = rate * tree.axisInLink[at + i];
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at);
    cross(linearVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      angularVelocity[at + i] += relativeVelocity[2 * at + i];
    }
  }

  private void slide(int link) {
    int at = 3 * link;
    double rate = v[tree.velocityAt[link]];
    for (int i = 0; i < 3; i++) {
      relativeVelocity[2 * at + 3 + i] = rate * tree.axisInLink[at + i];
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at + 3, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      linearVelocity[at + i] += relativeVelocity[2 * at + 3 + i];
    }
  }

  private void moveAlongColumns(int link) {
    int at = 3 * link;
    int first = tree.velocityAt[link];
    int end = first + tree.kind[link].velocityCount();
    for (int i = 0; i < 6; i++) {
      double sum = 0;
      for (int k = first; k < end; k++) {
        sum += v[k] * subspace[6 * k + i];
      }
      relativeVelocity[2 * at + i] = sum;
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at);
    cross(linearVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at + 3);
    addCross(angularVelocity, at, relativeVelocity, 2 * at + 3, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      angularVelocity[at + i] += relativeVelocity[2 * at + i];
      linearVelocity[at + i] += relativeVelocity[2 * at + 3 + i];
    }
  }

  /** A = X A_p + S a + c. */
  void accelerate(int link) {
    int at = 3 * link;
    carry(angularAcceleration, linearAcceleration, link);
    for (int i = 0; i < 3; i++) {
      angularAcceleration[at + i] += velocityProduct[2 * at + i];
      linearAcceleration[at + i] += velocityProduct[2 * at + 3 + i];
    }
    int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
    for (int k = tree.velocityAt[link]; k < end; k++) {
      for (int i = 0; i < 3; i++) {
        angularAcceleration[at + i] += a[k] * subspace[6 * k + i];
        linearAcceleration[at + i] += a[k] * subspace[6 * k + 3 + i];
      }
    }
  }

  private static void setZero(double[] out, int at) {
    out[at] = 0;
    out[at + 1] = 0;
    out[at + 2] = 0;
  }
}
