package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Finds joints that move no inertia at the start, such as those of a gimbal in a singular position.
 */
public final class InertiaCheck {
  /** Largest number of velocities; the mass matrix of a longer chain is too large. */
  private static final int MOST_VELOCITIES = 2000;

  private InertiaCheck() {}

  /**
   * Returns the first fault of the inertia of an open tree at the start. A tree whose bodies all
   * have inertia has none. Trees with loops are not checked, because loops may constrain a joint
   * without inertia.
   *
   * @param t time of the start, s
   */
  public static Optional<Finding> of(Mechanism mechanism, double t) {
    boolean sound = mechanism.bodies().stream().noneMatch(Body::isMassless);
    if (sound || !mechanism.closures().isEmpty() || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    motion.sweep(t, y);
    SemiRecursive.Workspace work = new SemiRecursive(tree).newWorkspace(motion);
    work.formMassMatrix();
    int velocity = work.factorMassMatrix();
    return velocity == ExplicitModel.REGULAR
        ? Optional.empty()
        : Optional.of(singular(mechanism, jointOf(mechanism, velocity)));
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

  private static Finding singular(Mechanism mechanism, int index) {
    Joint joint = mechanism.joints().get(index);
    List<String> chain = chain(mechanism, index);
    return new Finding(
        MessageCode.SINGULAR_INERTIA,
        "at the start no inertia resists joint \""
            + joint.name()
            + "\""
            + (chain.size() > 1
                ? ", which massless bodies join with "
                    + String.join(
                        ", ",
                        chain.subList(1, chain.size()).stream().map(n -> "\"" + n + "\"").toList())
                    + ": their freedoms coincide there"
                : "")
            + "; give the bodies between inertia, leave a joint out, or start elsewhere",
        joint.origin());
  }

  /**
   * Returns a joint and the joints beyond it that are connected with it by massless bodies only.
   */
  private static List<String> chain(Mechanism mechanism, int index) {
    List<String> names = new ArrayList<>();
    List<Integer> front = new ArrayList<>(List.of(index));
    while (!front.isEmpty()) {
      Joint joint = mechanism.joints().get(front.remove(0));
      names.add(joint.name());
      int child = joint.attachment().child();
      if (mechanism.bodies().get(child).isMassless()) {
        for (int j = 0; j < mechanism.joints().size(); j++) {
          if (mechanism.joints().get(j).attachment().parent() == child) {
            front.add(j);
          }
        }
      }
    }
    return names;
  }
}
