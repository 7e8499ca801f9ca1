package org.mechservice.solver.kinematics.pair;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.BitSet;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Pose, velocity and acceleration of a point and the axes of body B relative to body A, in A's
 * axes. Workspace of one thread.
 */
public final class RelativeMotion {
  private static final int ROOT = TreeGeometry.ROOT;

  final int linkA;
  final int linkB;

  /** Nearest common ancestor of A and B; joints between it and the root have no influence. */
  final int ancestor;

  /** Points on A and B from the reference points of their links, in link axes, m. */
  final double[] pointA = new double[3];

  final double[] pointB = new double[3];

  /** From B's axes to A's, row by row. */
  public final double[] rotation = new double[9];

  /** B's point from A's point, m; its first and second derivatives as seen from A. */
  public final double[] position = new double[3];

  public final double[] velocity = new double[3];
  public final double[] acceleration = new double[3];

  /** Angular velocity of B relative to A, rad/s, and its derivative as seen from A. */
  public final double[] angularVelocity = new double[3];

  public final double[] angularAcceleration = new double[3];

  private final TreeGeometry tree;
  private final double[] first = new double[3];
  private final double[] second = new double[3];
  private final double[] wrenchA = new double[6];
  private final double[] wrenchB = new double[6];

  /**
   * @param a point of body A
   * @param b point of body B
   */
  public RelativeMotion(TreeGeometry tree, BodyPoint a, BodyPoint b) {
    this.tree = tree;
    linkA = tree.linkOf(a.body());
    linkB = tree.linkOf(b.body());
    ancestor = tree.commonAncestor(linkA, linkB);
    tree.fromReference(a, pointA, 0);
    tree.fromReference(b, pointB, 0);
  }

  /** Returns the link of body A, or {@link TreeGeometry#ROOT}. */
  public int linkA() {
    return linkA;
  }

  /** Returns the link of body B, or {@link TreeGeometry#ROOT}. */
  public int linkB() {
    return linkB;
  }

  /**
   * Adds the links whose joints move B relative to A: those between either and the common ancestor.
   */
  public void addWays(BitSet links) {
    addWay(linkA, links);
    addWay(linkB, links);
  }

  private void addWay(int from, BitSet links) {
    for (int link = from; link != ancestor; link = tree.parent[link]) {
      links.set(link);
    }
  }

  /** Computes rotation and position from poses in the world. */
  public void place(TreeMotion motion) {
    double[] axesA = linkA == ROOT ? tree.rootRotation : motion.worldRotation;
    double[] axesB = linkB == ROOT ? tree.rootRotation : motion.worldRotation;
    int atA = linkA == ROOT ? 0 : 9 * linkA;
    int atB = linkB == ROOT ? 0 : 9 * linkB;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        rotation[3 * i + j] =
            axesA[atA + i] * axesB[atB + j]
                + axesA[atA + 3 + i] * axesB[atB + 3 + j]
                + axesA[atA + 6 + i] * axesB[atB + 6 + j];
      }
    }
    motion.points.difference(ancestor, linkA, pointA, 0, linkB, pointB, 0, first, 0);
    motion.fromWorld(linkA, first, 0, position, 0);
  }

  /** Computes velocities, after {@link #place}. */
  public void move(TreeMotion motion) {
    motion.points.velocity(linkA, pointA, 0, first, 0);
    motion.points.velocity(linkB, pointB, 0, second, 0);
    subtractFirst();
    motion.fromWorld(linkA, second, 0, velocity, 0);
    bodyVector(linkB, motion.angularVelocity, first);
    apply(rotation, 0, first, 0, angularVelocity, 0);
    if (linkA != ROOT) {
      // ρ' = v_B − v_A − ω_A × ρ
      bodyVector(linkA, motion.angularVelocity, first);
      cross(position, 0, first, 0, second, 0);
      for (int i = 0; i < 3; i++) {
        velocity[i] += second[i];
        angularVelocity[i] -= first[i];
      }
    }
  }

  /** Computes accelerations from the last acceleration sweep, after {@link #move}. */
  public void accelerate(TreeMotion motion) {
    motion.points.acceleration(linkA, pointA, 0, first, 0);
    motion.points.acceleration(linkB, pointB, 0, second, 0);
    subtractFirst();
    motion.fromWorld(linkA, second, 0, acceleration, 0);
    bodyVector(linkB, motion.angularAcceleration, first);
    apply(rotation, 0, first, 0, angularAcceleration, 0);
    if (linkA != ROOT) {
      accelerateFrom(motion);
    }
  }

  /** ρ'' −= α_A × ρ + ω_A × (ω_A × ρ + 2 ρ'), ω' −= α_A + ω_A × ω. */
  private void accelerateFrom(TreeMotion motion) {
    bodyVector(linkA, motion.angularAcceleration, first);
    cross(position, 0, first, 0, second, 0);
    for (int i = 0; i < 3; i++) {
      acceleration[i] += second[i];
      angularAcceleration[i] -= first[i];
    }
    bodyVector(linkA, motion.angularVelocity, first);
    cross(first, 0, position, 0, second, 0);
    for (int i = 0; i < 3; i++) {
      second[i] += 2 * velocity[i];
    }
    addCross(second, 0, first, 0, acceleration, 0);
    addCross(angularVelocity, 0, first, 0, angularAcceleration, 0);
  }

  private void subtractFirst() {
    for (int i = 0; i < 3; i++) {
      second[i] -= first[i];
    }
  }

  private static void bodyVector(int link, double[] all, double[] out) {
    for (int i = 0; i < 3; i++) {
      out[i] = link == ROOT ? 0 : all[3 * link + i];
    }
  }

  /**
   * Transfers a moment and a force on B at B's point, and the opposite on A, to the reference
   * points of the two links.
   *
   * @param gradient [moment; force] on B at its point, in A's axes; not modified
   * @param onA [moment; force] in A's axes at its reference point; overwritten
   * @param onB the same of B
   */
  public void wrenches(double[] gradient, double[] onA, double[] onB) {
    for (int i = 0; i < 3; i++) {
      first[i] = pointA[i] + position[i];
    }
    cross(gradient, 3, first, 0, onA, 0);
    for (int i = 0; i < 3; i++) {
      onA[i] -= gradient[i];
      onA[3 + i] = -gradient[3 + i];
    }
    applyTransposed(rotation, 0, gradient, 0, onB, 0);
    applyTransposed(rotation, 0, gradient, 3, onB, 3);
    addCross(pointB, 0, onB, 3, onB, 0);
  }

  /**
   * Adds the product of a gradient with the derivative of the relative velocity by the extended
   * velocities.
   *
   * @param row one number per extended velocity, from {@code at}; added to
   */
  public void addRow(TreeMotion motion, double[] gradient, double factor, double[] row, int at) {
    wrenches(gradient, wrenchA, wrenchB);
    addRow(motion, linkA, wrenchA, factor, row, at);
    addRow(motion, linkB, wrenchB, factor, row, at);
  }

  /**
   * Adds Sᵀ w for every link from one to the ancestor; contributions beyond the ancestor cancel.
   */
  private void addRow(
      TreeMotion motion, int link, double[] wrench, double factor, double[] row, int at) {
    for (int i = link; i != ancestor; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end; k++) {
        double sum = 0;
        for (int m = 0; m < 6; m++) {
          sum += wrench[m] * motion.subspace[6 * k + m];
        }
        row[at + k] += factor * sum;
      }
      if (tree.parent[i] != ancestor) {
        motion.wrenches.toParent(i, wrench, 0);
      }
    }
  }

  /**
   * Adds upper bounds of the elements of a row, reached if the joint motions are aligned with the
   * gradient. A row far below them consists of rounding errors.
   *
   * @param bounds one number per extended velocity, from {@code at}; added to
   */
  public void addRowBounds(TreeMotion motion, double[] gradient, double[] bounds, int at) {
    wrenches(gradient, wrenchA, wrenchB);
    addRowBounds(motion, linkA, wrenchA, bounds, at);
    addRowBounds(motion, linkB, wrenchB, bounds, at);
  }

  private void addRowBounds(TreeMotion motion, int link, double[] wrench, double[] bounds, int at) {
    for (int i = link; i != ancestor; i = tree.parent[i]) {
      double moment = Math.sqrt(dot(wrench, 0, wrench, 0));
      double force = Math.sqrt(dot(wrench, 3, wrench, 3));
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end; k++) {
        bounds[at + k] +=
            moment * Math.sqrt(dot(motion.subspace, 6 * k, motion.subspace, 6 * k))
                + force * Math.sqrt(dot(motion.subspace, 6 * k + 3, motion.subspace, 6 * k + 3));
      }
      motion.wrenches.toParent(i, wrench, 0);
    }
  }

  /**
   * Adds the wrenches of a gradient times a factor on both links.
   *
   * @param wrench [moment; force] 6 per link, in link axes at the reference point; added to
   */
  public void addWrenches(double[] gradient, double factor, double[] wrench) {
    wrenches(gradient, wrenchA, wrenchB);
    for (int i = 0; i < 6; i++) {
      if (linkA != ROOT) {
        wrench[6 * linkA + i] += factor * wrenchA[i];
      }
      if (linkB != ROOT) {
        wrench[6 * linkB + i] += factor * wrenchB[i];
      }
    }
  }
}
