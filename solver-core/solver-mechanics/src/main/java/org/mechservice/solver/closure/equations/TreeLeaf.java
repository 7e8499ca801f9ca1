package org.mechservice.solver.closure.equations;

import java.util.BitSet;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/** A position of a joint of the tree, driven or not. */
final class TreeLeaf extends CouplingLeaf {
  private final int position;
  final int velocity;
  private final int link;
  private final double size;

  TreeLeaf(JointCoordinate coordinate, String closure, TreeGeometry tree, double length) {
    int first = Integer.MAX_VALUE;
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.joint[link] == coordinate.joint() && tree.kind[link] != LinkKind.FIXED) {
        first = Math.min(first, tree.positionAt[link]);
      }
    }
    position = first + coordinate.component();
    int found = -1;
    for (int link = 0; link < tree.linkCount; link++) {
      boolean simple = tree.kind[link] != LinkKind.FIXED && tree.kind[link] != LinkKind.BALL;
      if (simple && tree.joint[link] == coordinate.joint() && tree.positionAt[link] == position) {
        found = link;
      }
    }
    if (found < 0) {
      throw new IllegalArgumentException(
          "constraint " + closure + " cannot relate Euler parameters");
    }
    link = found;
    velocity = tree.velocityAt[found];
    size = tree.kind[found] == LinkKind.SLIDE ? length : 1;
  }

  @Override
  double value(TreeMotion motion, double t) {
    return motion.q[position];
  }

  @Override
  double rate(TreeMotion motion) {
    return motion.v[velocity];
  }

  @Override
  double acceleration(TreeMotion motion) {
    return motion.a[velocity];
  }

  @Override
  double size() {
    return size;
  }

  @Override
  int[] links() {
    return new int[] {link};
  }

  @Override
  void addSupport(BitSet ways, BitSet loaded, BitSet velocities) {
    ways.set(link);
    velocities.set(velocity);
  }

  @Override
  void addRow(TreeMotion motion, double factor, double[] rows, int at) {
    rows[at + velocity] += factor;
  }

  @Override
  void addForce(double force, double[] wrench, double[] tau) {
    tau[velocity] += force;
  }

  @Override
  void byCoordinate(double stiffness, int by, ForceJacobian sink) {
    sink.forceByCoordinate(velocity, by, stiffness, 0);
  }

  @Override
  void byLink(double stiffness, int link, double[] wrench, ForceJacobian sink) {
    if (link != TreeGeometry.ROOT) {
      sink.forceByLink(velocity, link, scaled(stiffness, wrench), NO_RATES);
    }
  }
}
