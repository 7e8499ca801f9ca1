package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** The joints that have states, and their velocities. Immutable. */
final class StateJoints {
  /**
   * Fraction of the largest velocity below which a joint takes no part in a motion; zero pivots are
   * found at 1e-14.
   */
  private static final double TAKES_PART = 1e-6;

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

  /** Returns whether the joint of a velocity has more than one. */
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

  /** Returns whether only one joint with a single velocity takes part in a motion. */
  boolean isSingle(double[] motion) {
    return moving(motion).size() == 1 && !hasSeveral(moving(motion).get(0));
  }

  /** Returns the defect of a motion without inertia. */
  Defect singular(SingularInertia found) {
    if (found.isOfDifferentSizes()) {
      return new Defect(
          MessageCode.SINGULAR_INERTIA,
          name(found.velocity()),
          "The inertia is singular to double precision: " + found.sizes() + ".",
          "Bring the masses or inertias of the two bodies nearer together, connect them rigidly, or"
              + " leave the light one out.");
    }
    List<Integer> moving = moving(found.motion());
    String names = moving.stream().map(this::name).collect(Collectors.joining(" and "));
    return moving.size() == 1
        ? new Defect(
            MessageCode.SINGULAR_INERTIA,
            names,
            "The inertia is singular: no body beyond this joint has inertia in this direction.",
            "Give a body beyond it mass or inertia in this direction, or use a joint without this"
                + " degree of freedom.")
        : new Defect(
            MessageCode.SINGULAR_INERTIA,
            names,
            "The inertia is singular: these joints move no inertia when they move together.",
            "Give the bodies between them mass or inertia, or remove a joint; the usual cause is"
                + " axes that coincide, with massless bodies between them.");
  }

  /** Returns the velocities that take part in a motion. */
  private static List<Integer> moving(double[] motion) {
    double largest = Arrays.stream(motion).map(Math::abs).max().orElse(0);
    return IntStream.range(0, motion.length)
        .filter(k -> Math.abs(motion[k]) > TAKES_PART * largest)
        .boxed()
        .toList();
  }
}
