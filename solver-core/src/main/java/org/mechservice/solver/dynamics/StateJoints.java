package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.Defects.Defect;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/** The joints that have states, and which velocity belongs to which. Immutable. */
final class StateJoints {
  private final List<JointVariables> joints = new ArrayList<>();

  /** For each velocity the index of its joint among those that have states. */
  private final int[] jointOfVelocity;

  private final int[] firstVelocity;

  StateJoints(Mechanism mechanism) {
    jointOfVelocity = new int[mechanism.velocityCount()];
    firstVelocity = new int[mechanism.joints().size()];
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (!mechanism.isDriven(j)) {
        Joint joint = mechanism.joints().get(j);
        int at = mechanism.velocityOffset(j);
        Arrays.fill(jointOfVelocity, at, at + joint.type().velocityCount(), joints.size());
        firstVelocity[joints.size()] = at;
        joints.add(new JointVariables(joint.name(), joint.type()));
      }
    }
  }

  /** Returns names and types in state order. */
  List<JointVariables> variables() {
    return List.copyOf(joints);
  }

  /** Returns the index of a velocity's joint among those that have states. */
  int jointOf(int velocity) {
    return jointOfVelocity[velocity];
  }

  /** Returns nv. */
  int velocityCount() {
    return jointOfVelocity.length;
  }

  /** Returns whether the joint of a velocity has others too. */
  boolean hasSeveral(int velocity) {
    return joints.get(jointOfVelocity[velocity]).type().velocityCount() > 1;
  }

  /** Returns the joint of a velocity, and which of its velocities if it has several. */
  String name(int velocity) {
    JointVariables joint = joints.get(jointOfVelocity[velocity]);
    String name = "joint \"" + joint.name() + "\"";
    int component = velocity - firstVelocity[jointOfVelocity[velocity]];
    return hasSeveral(velocity)
        ? name + ", velocity " + joint.name() + ".v[" + component + "]"
        : name;
  }

  /** Says that nothing resists a velocity of a joint that has several. */
  Defect singular(int velocity) {
    return new Defect(
        "N-002",
        name(velocity),
        "The inertia is singular: nothing beyond this joint resists its motion in this direction.",
        "Give a body beyond it mass or inertia in this direction, or take a joint without this"
            + " freedom.");
  }
}
