package org.mechservice.benchmarks.peer;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * A tree of turning and sliding joints, all frames parallel, as MuJoCo reads it. Bodies nest there,
 * and none may be massless: the joints of one go to the body it carries.
 */
final class MujocoText {
  private final Mechanism mechanism;
  private final StringBuilder text = new StringBuilder();
  private final List<Integer> order = new ArrayList<>();

  MujocoText(Mechanism mechanism) {
    this.mechanism = mechanism;
    text.append("<mujoco><compiler angle='radian' balanceinertia='false' boundmass='0'");
    text.append(" boundinertia='0'/><option gravity='").append(numbers(mechanism.gravity()));
    text.append("'><flag contact='disable' constraint='disable'/></option><worldbody>");
    addBodies(Mechanism.ROOT);
    text.append("</worldbody></mujoco>\n");
  }

  /** Returns the model. */
  String model() {
    return text.toString();
  }

  /** Returns positions and velocities in the order of its joints, and where the last joint is. */
  String state(double[] y) {
    StringBuilder state = new StringBuilder();
    for (int half = 0; half < 2; half++) {
      for (int joint : order) {
        state.append(y[half * order.size() + joint]).append('\n');
      }
    }
    return state.append(order.indexOf(order.size() - 1)).append('\n').toString();
  }

  private void addBodies(int parent) {
    for (int j : mechanism.outward()) {
      if (mechanism.joints().get(j).attachment().parent() == parent) {
        addBody(j);
      }
    }
  }

  private void addBody(int first) {
    List<Integer> joints = new ArrayList<>(List.of(first));
    while (body(joints).isMassless()) {
      int massless = child(joints);
      joints.add(onlyJoint(massless));
    }
    text.append("<body pos='").append(numbers(from(joints, 0))).append("'>");
    for (int k = 0; k < joints.size(); k++) {
      Joint joint = mechanism.joints().get(joints.get(k));
      order.add(joints.get(k));
      text.append("<joint type='").append(joint instanceof Revolute ? "hinge" : "slide");
      text.append("' axis='").append(numbers(axis(joint))).append("' pos='");
      text.append(numbers(from(joints, k + 1).times(-1))).append("'/>");
    }
    Body body = body(joints);
    InertiaTensor i = body.inertia();
    text.append("<inertial pos='").append(numbers(body.centerOfMass())).append("' mass='");
    text.append(body.mass()).append("' fullinertia='").append(i.xx()).append(' ').append(i.yy());
    text.append(' ').append(i.zz()).append(' ').append(i.xy()).append(' ').append(i.xz());
    text.append(' ').append(i.yz()).append("'/>");
    addBodies(child(joints));
    text.append("</body>");
  }

  /** The way from where a joint is to where the last is. */
  private Vector3 from(List<Integer> joints, int first) {
    Vector3 way = Vector3.ZERO;
    for (int k = first; k < joints.size(); k++) {
      way = way.plus(mechanism.joints().get(joints.get(k)).attachment().parentPoint());
    }
    return way;
  }

  private int child(List<Integer> joints) {
    return mechanism.joints().get(joints.get(joints.size() - 1)).attachment().child();
  }

  private Body body(List<Integer> joints) {
    return mechanism.bodies().get(child(joints));
  }

  private int onlyJoint(int parent) {
    int found = -1;
    for (int j : mechanism.outward()) {
      if (mechanism.joints().get(j).attachment().parent() == parent) {
        if (found >= 0) {
          throw new IllegalArgumentException("a massless body carries two others");
        }
        found = j;
      }
    }
    return found;
  }

  private static Vector3 axis(Joint joint) {
    return joint instanceof Revolute revolute ? revolute.axis() : ((Prismatic) joint).axis();
  }

  private static String numbers(Vector3 v) {
    return v.x() + " " + v.y() + " " + v.z();
  }
}
