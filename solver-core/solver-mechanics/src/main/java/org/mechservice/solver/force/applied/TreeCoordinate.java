package org.mechservice.solver.force.applied;

import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Indices of a tree joint's coordinate among the extended positions and velocities.
 *
 * @param position index of the position, or −1 if a velocity is not the rate of one
 * @param velocity index of its rate, or −1 for an Euler parameter
 */
public record TreeCoordinate(int position, int velocity) {

  /**
   * Finds a position.
   *
   * @throws IllegalArgumentException if the joint has no such position
   */
  public static TreeCoordinate ofPosition(TreeGeometry tree, JointCoordinate coordinate) {
    check(tree, coordinate, joint(tree, coordinate).type().positionCount());
    int position = first(tree, coordinate.joint(), true) + coordinate.component();
    for (int link = 0; link < tree.linkCount; link++) {
      if (isScalar(tree, link, coordinate.joint()) && tree.positionAt[link] == position) {
        return new TreeCoordinate(position, tree.velocityAt[link]);
      }
    }
    return new TreeCoordinate(position, -1);
  }

  /**
   * Finds a velocity.
   *
   * @throws IllegalArgumentException if the joint has no such velocity
   */
  public static TreeCoordinate ofVelocity(TreeGeometry tree, JointCoordinate coordinate) {
    check(tree, coordinate, joint(tree, coordinate).type().velocityCount());
    int velocity = first(tree, coordinate.joint(), false) + coordinate.component();
    for (int link = 0; link < tree.linkCount; link++) {
      if (isScalar(tree, link, coordinate.joint()) && tree.velocityAt[link] == velocity) {
        return new TreeCoordinate(tree.positionAt[link], velocity);
      }
    }
    return new TreeCoordinate(-1, velocity);
  }

  private static Joint joint(TreeGeometry tree, JointCoordinate coordinate) {
    int count = tree.mechanism().joints().size();
    if (coordinate.joint() < 0 || coordinate.joint() >= count) {
      throw new IllegalArgumentException(
          "joint " + coordinate.joint() + " of " + count + " is not there");
    }
    return tree.mechanism().joints().get(coordinate.joint());
  }

  private static void check(TreeGeometry tree, JointCoordinate coordinate, int count) {
    if (coordinate.component() < 0 || coordinate.component() >= count) {
      throw new IllegalArgumentException(
          "joint "
              + joint(tree, coordinate).name()
              + " has "
              + count
              + " components; component "
              + coordinate.component()
              + " is not among them");
    }
  }

  private static boolean isScalar(TreeGeometry tree, int link, int joint) {
    return tree.joint[link] == joint
        && tree.kind[link] != LinkKind.FIXED
        && tree.kind[link] != LinkKind.BALL;
  }

  /**
   * Returns the joint's first index; its links hold the coordinates contiguously, but not always in
   * order.
   */
  private static int first(TreeGeometry tree, int joint, boolean positions) {
    int first = Integer.MAX_VALUE;
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.joint[link] == joint && tree.kind[link] != LinkKind.FIXED) {
        first = Math.min(first, positions ? tree.positionAt[link] : tree.velocityAt[link]);
      }
    }
    return first;
  }
}
