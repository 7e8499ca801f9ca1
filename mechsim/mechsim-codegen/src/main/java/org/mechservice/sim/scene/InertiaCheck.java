package org.mechservice.sim.scene;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.SingularInertia;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Finds joints that move no inertia at the start: a body whose mass lies on the axis of its hinge,
 * a gimbal in a singular position, a light body that carries one too heavy for double precision. A
 * run ends at its start with N-002 there.
 */
public final class InertiaCheck {
  /** Part of the largest velocity of a motion below which a joint takes no part in it. */
  private static final double TAKES_PART = 1e-6;

  /** Rate of a constraint, relative to its size, that is rounding. */
  private static final double ROUNDING = 1e-12;

  private InertiaCheck() {}

  /**
   * Returns the first fault of the inertia at the start. Where constraints resist the motion
   * without inertia there is none.
   *
   * @param t time of the start, s
   */
  public static Optional<Finding> of(Mechanism mechanism, double t) {
    if (mechanism.velocityCount() == 0) {
      return Optional.empty();
    }
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    motion.sweep(t, start(mechanism));
    return SingularInertia.find(motion, t)
        .filter(found -> isFree(found, tree, t))
        .map(found -> finding(mechanism, found));
  }

  private static double[] start(Mechanism mechanism) {
    double[] y = new double[mechanism.stateCount()];
    mechanism.initialState(y);
    return y;
  }

  /** Returns whether no constraint resists a motion. */
  private static boolean isFree(SingularInertia found, TreeGeometry tree, double t) {
    Mechanism mechanism = tree.mechanism();
    if (mechanism.closures().isEmpty()) {
      return true;
    }
    if (!new MassiveRods(tree).isEmpty()) {
      return false;
    }
    double[] y = start(mechanism);
    Arrays.fill(y, mechanism.positionCount(), y.length, 0);
    LoopEquations loops = new LoopEquations(tree);
    double[] rest = rates(loops, tree, t, y);
    double[] motion = found.motion();
    System.arraycopy(motion, 0, y, mechanism.positionCount(), motion.length);
    double[] moving = rates(loops, tree, t, y);
    for (int row = 0; row < moving.length; row++) {
      if (Math.abs(moving[row] - rest[row]) > ROUNDING * loops.size(row)) {
        return false;
      }
    }
    return true;
  }

  private static double[] rates(LoopEquations loops, TreeGeometry tree, double t, double[] y) {
    TreeMotion motion = new TreeMotion(tree);
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.move(motion, t);
    return Arrays.copyOf(loops.rate, loops.count());
  }

  /** Returns the joint that a velocity belongs to. */
  public static Joint jointAt(Mechanism mechanism, int velocity) {
    return mechanism.joints().get(jointOf(mechanism, velocity));
  }

  private static int jointOf(Mechanism mechanism, int velocity) {
    int joint = 0;
    for (int j = 0; j < mechanism.joints().size(); j++) {
      boolean hasStates =
          !mechanism.isDriven(j) && mechanism.joints().get(j).type().velocityCount() > 0;
      if (hasStates && mechanism.velocityOffset(j) <= velocity) {
        joint = j;
      }
    }
    return joint;
  }

  private static Finding finding(Mechanism mechanism, SingularInertia found) {
    int index = jointOf(mechanism, found.velocity());
    Joint joint = mechanism.joints().get(index);
    if (found.isOfDifferentSizes()) {
      return new Finding(
          MessageCode.SINGULAR_INERTIA,
          "at the start the inertia at joint \""
              + joint.name()
              + "\" is singular to double precision: "
              + found.sizes()
              + "; bring the masses or inertias of the two bodies nearer together, connect them"
              + " rigidly, or leave the light one out",
          joint.origin());
    }
    List<String> others = others(mechanism, found, index);
    if (others.isEmpty()) {
      return alone(mechanism, joint);
    }
    List<String> between = joinedByMassless(mechanism, index);
    return between.isEmpty()
        ? coinciding(joint, "when it moves together with ", others)
        : coinciding(joint, "which massless bodies join with ", between);
  }

  /** Returns the other joints that take part in a motion. */
  private static List<String> others(Mechanism mechanism, SingularInertia found, int first) {
    double[] motion = found.motion();
    double largest = Arrays.stream(motion).map(Math::abs).max().orElse(0);
    TreeSet<Integer> joints = new TreeSet<>();
    for (int k = 0; k < motion.length; k++) {
      if (Math.abs(motion[k]) > TAKES_PART * largest) {
        joints.add(jointOf(mechanism, k));
      }
    }
    joints.remove(first);
    List<String> names = new ArrayList<>();
    joints.forEach(j -> names.add(mechanism.joints().get(j).name()));
    return names;
  }

  private static Finding alone(Mechanism mechanism, Joint joint) {
    return new Finding(
        MessageCode.JOINT_MOVES_NO_MASS,
        "joint \""
            + joint.name()
            + "\" moves body \""
            + mechanism.bodies().get(joint.attachment().child()).name()
            + "\" in a direction in which neither it nor what is beyond it has inertia: their mass"
            + " lies on the axis; its acceleration is not defined; give a body there a moment of"
            + " inertia about the axis, or leave the joint out",
        joint.origin());
  }

  private static Finding coinciding(Joint joint, String how, List<String> others) {
    return new Finding(
        MessageCode.SINGULAR_INERTIA,
        "at the start no inertia resists joint \""
            + joint.name()
            + "\", "
            + how
            + others.stream().map(name -> "\"" + name + "\"").collect(Collectors.joining(", "))
            + ": their freedoms coincide there; give the bodies between inertia, leave a joint out,"
            + " or start elsewhere",
        joint.origin());
  }

  /** Returns the joints beyond a joint that are connected with it by massless bodies only. */
  private static List<String> joinedByMassless(Mechanism mechanism, int index) {
    List<String> names = new ArrayList<>();
    Deque<Integer> front = new ArrayDeque<>(List.of(index));
    while (!front.isEmpty()) {
      int child = mechanism.joints().get(front.remove()).attachment().child();
      for (int j = 0; j < mechanism.joints().size(); j++) {
        Joint joint = mechanism.joints().get(j);
        if (mechanism.bodies().get(child).isMassless() && joint.attachment().parent() == child) {
          names.add(joint.name());
          front.add(j);
        }
      }
    }
    return names;
  }
}
