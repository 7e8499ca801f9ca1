package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;

/** Finds joints that move no mass. */
final class MasslessJointCheck {
  private MasslessJointCheck() {}

  /** Returns the findings, outwards from the root. */
  static List<Finding> of(Mechanism mechanism) {
    boolean[] heavy = heavy(mechanism);
    List<Finding> findings = new ArrayList<>();
    for (int index : mechanism.outward()) {
      Joint joint = mechanism.joints().get(index);
      int child = joint.attachment().child();
      Body body = mechanism.bodies().get(child);
      boolean moves = joint.type() != JointType.W && !mechanism.isDriven(index);
      if (moves && !heavy[child] && !mechanism.isWhollyArmed(index)) {
        findings.add(movesNothing(joint, body));
      }
    }
    return findings;
  }

  /** Returns whether there is mass or inertia in each body or beyond it. */
  private static boolean[] heavy(Mechanism mechanism) {
    boolean[] heavy = new boolean[mechanism.bodies().size()];
    for (LoopClosure closure : mechanism.closures()) {
      // A body of a loop may get its inertia through the loop.
      LoopPaths.indices(closure).stream()
          .filter(body -> body != Mechanism.ROOT)
          .forEach(body -> heavy[body] = true);
    }
    int[] outward = mechanism.outward();
    for (int i = outward.length - 1; i >= 0; i--) {
      Attachment attachment = mechanism.joints().get(outward[i]).attachment();
      int child = attachment.child();
      heavy[child] |= !mechanism.bodies().get(child).isMassless();
      if (attachment.parent() != Mechanism.ROOT) {
        heavy[attachment.parent()] |= heavy[child];
      }
    }
    return heavy;
  }

  private static Finding movesNothing(Joint joint, Body body) {
    return new Finding(
        MessageCode.JOINT_MOVES_NO_MASS,
        "joint \""
            + joint.name()
            + "\" moves body \""
            + body.name()
            + "\" and nothing beyond it that has mass: its acceleration is not defined; give a body"
            + " there mass and inertia, or leave the joint out",
        joint.origin());
  }
}
