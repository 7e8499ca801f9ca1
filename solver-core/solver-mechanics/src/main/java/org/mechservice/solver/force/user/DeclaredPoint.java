package org.mechservice.solver.force.user;

import static org.mechservice.solver.spatial.Blocks.addCross;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/** A point that a user force reads or acts on: its readings and its loads. */
final class DeclaredPoint {
  final int link;
  final Set<Reads> reads;

  /** Readings in world axes: m, row by row, m/s, rad/s. */
  final double[] position = new double[3];

  final double[] rotation = new double[9];
  final double[] velocity = new double[3];
  final double[] angularVelocity = new double[3];

  /** Force at the point and torque added by {@code apply}, world axes, N, N·m. */
  final double[] load = new double[6];

  private final double[] r = new double[3];
  private final double[] axis = new double[3];
  private final double[] column = new double[3];
  private final double[] turned = new double[6];
  private final double[] change = new double[6];

  DeclaredPoint(TreeGeometry tree, BodyPoint point, Set<Reads> reads) {
    link = tree.linkOf(point.body());
    this.reads = reads.isEmpty() ? EnumSet.noneOf(Reads.class) : EnumSet.copyOf(reads);
    tree.fromReference(point, r, 0);
  }

  /** Sets the readings from a swept motion. */
  void read(TreeMotion motion) {
    motion.points.position(link, r, 0, position, 0);
    motion.points.velocity(link, r, 0, velocity, 0);
    for (int j = 0; j < 3; j++) {
      axis[0] = j == 0 ? 1 : 0;
      axis[1] = j == 1 ? 1 : 0;
      axis[2] = j == 2 ? 1 : 0;
      motion.toWorld(link, axis, 0, column, 0);
      for (int i = 0; i < 3; i++) {
        rotation[3 * i + j] = column[i];
      }
    }
    if (link != TreeGeometry.ROOT) {
      motion.toWorld(link, motion.angularVelocity, 3 * link, angularVelocity, 0);
    }
  }

  /**
   * Writes a force and a torque as a wrench in link axes.
   *
   * @param forceTorque world axes
   * @param out [moment; force] at the link's reference point; overwritten
   */
  void toWrench(TreeMotion motion, double[] forceTorque, double[] out) {
    motion.fromWorld(link, forceTorque, 0, turned, 0);
    motion.fromWorld(link, forceTorque, 3, turned, 3);
    for (int i = 0; i < 3; i++) {
      out[i] = turned[3 + i];
      out[3 + i] = turned[i];
    }
    addCross(r, 0, turned, 0, out, 0);
  }

  /**
   * Writes the derivative, in the axes of the rotating link, of {@link #load}, which is constant in
   * the world.
   *
   * @param byPlace 6 × 6; its columns of displacement are left as they are
   */
  void turnAgainstLink(TreeMotion motion, double[] byPlace) {
    motion.fromWorld(link, load, 0, turned, 0);
    motion.fromWorld(link, load, 3, turned, 3);
    for (int j = 0; j < 3; j++) {
      axis[0] = j == 0 ? 1 : 0;
      axis[1] = j == 1 ? 1 : 0;
      axis[2] = j == 2 ? 1 : 0;
      Arrays.fill(change, 0);
      addCross(turned, 3, axis, 0, change, 0);
      addCross(turned, 0, axis, 0, change, 3);
      addCross(r, 0, change, 3, change, 0);
      for (int i = 0; i < 6; i++) {
        byPlace[6 * i + j] = change[i];
      }
    }
  }

  /** Returns the power of {@link #load}, W. */
  double power() {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum += load[i] * velocity[i] + load[3 + i] * angularVelocity[i];
    }
    return sum;
  }
}
