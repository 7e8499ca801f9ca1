package org.mechservice.solver.mechanism;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Inertia that resists the acceleration of a joint's coordinates alone, as the rotor of a motor
 * behind a gear: it is added to the diagonal of the mass matrix. The momentum that the rotor has
 * because the joint's bodies move, and its gyroscopic moments, are left out
 * (docs/theory/motion.md#armature).
 *
 * @param joint index among the mechanism's joints
 * @param inertias one number per velocity of the joint, kg·m² or kg; the three of a rotation by
 *     Euler parameters are equal
 */
public record Armature(int joint, List<Double> inertias) {
  public Armature {
    inertias = List.copyOf(inertias);
  }

  /** Returns whether every velocity of the joint has an inertia. */
  public boolean isWhole() {
    return !inertias.isEmpty() && inertias.stream().allMatch(inertia -> inertia > 0);
  }

  /**
   * Rejects armatures that do not fit the joints.
   *
   * @throws IllegalArgumentException naming the joint
   */
  static void check(List<Armature> armatures, List<Joint> joints) {
    Set<Integer> seen = new HashSet<>();
    for (Armature armature : armatures) {
      if (armature.joint < 0 || armature.joint >= joints.size()) {
        throw new IllegalArgumentException("an armature names joint " + armature.joint);
      }
      Joint joint = joints.get(armature.joint);
      List<Double> given = armature.inertias;
      boolean fits =
          given.size() == joint.type().velocityCount()
              && given.stream().allMatch(inertia -> inertia >= 0 && Double.isFinite(inertia))
              && (!joint.type().hasEulerParameters()
                  || Set.copyOf(given.subList(0, 3)).size() == 1);
      if (!fits || !seen.add(armature.joint)) {
        throw new IllegalArgumentException(
            "joint " + joint.name() + " of type " + joint.type() + " has armature " + given);
      }
    }
  }
}
