package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntUnaryOperator;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.text.Origin;

/** Chains of any length, of links of the timing model chain200. */
public final class Chains {
  /** Two links that are alike but for their numbers; the first two hang on what rests. */
  private static final int FIRST_OF_PAIR = 2;

  private Chains() {}

  /** A chain in which two links take turns. */
  public static Mechanism ofEqualLinks(int links) {
    return chain("equal" + links, links, i -> FIRST_OF_PAIR + i % 2);
  }

  /** A chain in which each of 200 links has numbers of its own. */
  public static Mechanism ofDifferentLinks(int links) {
    return chain("different" + links, links, i -> i % 200);
  }

  private static Mechanism chain(String name, int links, IntUnaryOperator kind) {
    Mechanism model = Scenes.timingModel("chain200").mechanism();
    List<Body> bodies = new ArrayList<>();
    List<Revolute> joints = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      int k = kind.applyAsInt(i);
      Body body = model.bodies().get(k);
      bodies.add(new Body("b" + i, body.mass(), body.centerOfMass(), body.inertia(), Origin.NONE));
      Revolute joint = (Revolute) model.joints().get(k);
      Attachment place = joint.attachment();
      Attachment attachment =
          new Attachment(i - 1, place.parentPoint(), i, place.childPoint(), place.zeroRotation());
      joints.add(new Revolute("j" + i, attachment, joint.axis(), 0.3, 0.1, Origin.NONE));
    }
    return new Mechanism(name, model.root(), model.gravity(), bodies, List.copyOf(joints));
  }
}
