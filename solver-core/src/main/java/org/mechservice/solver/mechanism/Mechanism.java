package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;

/**
 * A tree of rigid bodies hanging on a root at rest.
 *
 * <p>Bodies and joints stand in the order of the model file. Each body is the child of exactly one
 * joint. The state y = [q; v] takes the joints in that order; {@link #outward()} gives them from
 * the root to the leaves.
 */
public final class Mechanism {
  /** Index of the root where a body is meant. */
  public static final int ROOT = -1;

  private final String name;
  private final Root root;
  private final Vector3 gravity;
  private final List<Body> bodies;
  private final List<Joint> joints;
  private final int[] outward;
  private final int[] jointOfBody;
  private final int[] positionOffset;
  private final int[] velocityOffset;

  /**
   * Joins bodies to a tree.
   *
   * @param name the model's name
   * @param root the body at rest
   * @param gravity acceleration of free fall in world axes, m/s²
   * @param bodies the moving bodies in file order
   * @param joints one joint per body in file order, each leading from the parent outwards
   * @throws IllegalArgumentException if a body index is out of range, a body is the child of no
   *     joint or of two, or the joints do not lead from the root to every body
   */
  public Mechanism(String name, Root root, Vector3 gravity, List<Body> bodies, List<Joint> joints) {
    this.name = name;
    this.root = root;
    this.gravity = gravity;
    this.bodies = List.copyOf(bodies);
    this.joints = List.copyOf(joints);
    this.jointOfBody = jointOfBody(this.bodies, this.joints);
    this.outward = outward(this.bodies, this.joints, jointOfBody);
    this.positionOffset = new int[joints.size() + 1];
    this.velocityOffset = new int[joints.size() + 1];
    for (int i = 0; i < joints.size(); i++) {
      JointType type = this.joints.get(i).type();
      positionOffset[i + 1] = positionOffset[i] + type.positionCount();
      velocityOffset[i + 1] = velocityOffset[i] + type.velocityCount();
    }
  }

  private static int[] jointOfBody(List<Body> bodies, List<Joint> joints) {
    int[] jointOf = new int[bodies.size()];
    Arrays.fill(jointOf, -1);
    for (int j = 0; j < joints.size(); j++) {
      Attachment attachment = joints.get(j).attachment();
      int child = attachment.child();
      if (child < 0 || child >= bodies.size() || attachment.parent() >= bodies.size()) {
        throw new IllegalArgumentException(
            "joint " + joints.get(j).name() + " names a body that is not there");
      }
      if (jointOf[child] != -1) {
        throw new IllegalArgumentException(
            "body " + bodies.get(child).name() + " is the child of two joints");
      }
      jointOf[child] = j;
    }
    return jointOf;
  }

  private static int[] outward(List<Body> bodies, List<Joint> joints, int[] jointOfBody) {
    List<Integer> order = new ArrayList<>();
    boolean[] reached = new boolean[bodies.size()];
    int[] onPathOf = new int[bodies.size()];
    Arrays.fill(onPathOf, ROOT);
    for (int body = 0; body < bodies.size(); body++) {
      List<Integer> path = new ArrayList<>();
      for (int b = body; b != ROOT && !reached[b]; ) {
        int joint = jointOfBody[b];
        if (joint == -1 || onPathOf[b] == body) {
          throw new IllegalArgumentException(
              "body " + bodies.get(b).name() + " does not hang on the root");
        }
        onPathOf[b] = body;
        path.add(joint);
        b = joints.get(joint).attachment().parent();
      }
      for (int i = path.size() - 1; i >= 0; i--) {
        order.add(path.get(i));
        reached[joints.get(path.get(i)).attachment().child()] = true;
      }
    }
    return order.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Returns the model's name. */
  public String name() {
    return name;
  }

  /** Returns the body at rest. */
  public Root root() {
    return root;
  }

  /** Returns the acceleration of free fall in world axes, m/s². */
  public Vector3 gravity() {
    return gravity;
  }

  /** Returns the moving bodies in file order. */
  public List<Body> bodies() {
    return bodies;
  }

  /** Returns the joints in file order, which is state order. */
  public List<Joint> joints() {
    return joints;
  }

  /**
   * Returns the joints' indices from the root to the leaves: every joint comes after the joint of
   * its parent body.
   */
  public int[] outward() {
    return outward.clone();
  }

  /** Returns the index of the joint whose child is {@code body}. */
  public int jointOf(int body) {
    return jointOfBody[body];
  }

  /** Returns whether a joint's coordinates follow prescribed motions and are no states. */
  public boolean isDriven(int joint) {
    return false;
  }

  /** Returns where the positions of joint {@code joint} begin in q. */
  public int positionOffset(int joint) {
    return positionOffset[joint];
  }

  /** Returns where the velocities of joint {@code joint} begin in v. */
  public int velocityOffset(int joint) {
    return velocityOffset[joint];
  }

  /** Returns the number of positions, nq. */
  public int positionCount() {
    return positionOffset[joints.size()];
  }

  /** Returns the number of velocities, nv. */
  public int velocityCount() {
    return velocityOffset[joints.size()];
  }

  /**
   * Writes the state at the start.
   *
   * @param y state [q; v], length nq + nv; overwritten
   */
  public void initialState(double[] y) {
    for (int j = 0; j < joints.size(); j++) {
      joints.get(j).initialPositions(y, positionOffset[j]);
      joints.get(j).initialVelocities(y, positionCount() + velocityOffset[j]);
    }
  }
}
