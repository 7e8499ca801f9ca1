package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.standalone.ShortestDecimal;

/** Looks for what the author of a mechanism may not have meant. */
final class Findings {
  /** How far principal moments of a rounded tensor may miss the triangle inequality. */
  private static final double ROUNDED = 1e-6;

  private Findings() {}

  /** Returns the findings, outwards from the root. */
  static List<Finding> of(Mechanism mechanism) {
    boolean[] heavy = heavy(mechanism);
    List<Finding> findings = new ArrayList<>();
    for (int index : mechanism.outward()) {
      Joint joint = mechanism.joints().get(index);
      int child = joint.attachment().child();
      Body body = mechanism.bodies().get(child);
      if (!heavy[child]) {
        findings.add(movesNothing(joint, body));
      }
      addImpossibleInertia(body, findings);
    }
    return findings;
  }

  /** Returns whether there is mass or inertia in each body or beyond it. */
  private static boolean[] heavy(Mechanism mechanism) {
    boolean[] heavy = new boolean[mechanism.bodies().size()];
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
        "S-086",
        "joint \""
            + joint.name()
            + "\" moves body \""
            + body.name()
            + "\" and nothing beyond it that has mass: its acceleration is not defined; give a body"
            + " there mass and inertia, or leave the joint out",
        joint.origin());
  }

  /** No moment of inertia of a body exceeds the sum of the other two. */
  private static void addImpossibleInertia(Body body, List<Finding> findings) {
    double[] moments = PrincipalMoments.of(body.inertia());
    double rounded = ROUNDED * Math.abs(body.inertia().trace());
    if (moments[0] < -rounded || moments[2] > moments[0] + moments[1] + rounded) {
      findings.add(
          new Finding(
              "S-087",
              "no body has the inertia of \""
                  + body.name()
                  + "\": its principal moments are "
                  + ShortestDecimal.format(moments[0])
                  + ", "
                  + ShortestDecimal.format(moments[1])
                  + " and "
                  + ShortestDecimal.format(moments[2])
                  + " kg m^2, and each must lie between 0 and the sum of the others; check the"
                  + " signs of the products of inertia and the units",
              body.origin()));
    }
  }
}
