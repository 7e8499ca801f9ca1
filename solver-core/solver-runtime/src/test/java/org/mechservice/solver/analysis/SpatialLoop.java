package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * One loop of four joints and three bodies with one degree of freedom and no redundant equation,
 * cut wherever it is wanted. All frames coincide with the world's at zero.
 *
 * <pre>
 * ground --R-- crank --S-- coupler --U-- rocker --R (or P)-- ground
 * </pre>
 */
final class SpatialLoop {
  static final int JOINTS = 4;
  private static final Vector3[] POINTS = {
    new Vector3(0, 0, 0),
    new Vector3(0.1, 0.05, 0.3),
    new Vector3(0.9, 0.2, 0.5),
    new Vector3(1, 0.3, -0.1)
  };
  private static final Vector3 GRAVITY = new Vector3(0.4, -1, -9.7);

  private SpatialLoop() {}

  private static Vector3 unit(double x, double y, double z) {
    return new Vector3(x, y, z).normalized();
  }

  private static Joint joint(int k, boolean sliding) {
    Vector3 point = POINTS[k];
    int body1 = k - 1;
    int body2 = k == JOINTS - 1 ? Mechanism.ROOT : k;
    Attachment at = new Attachment(body1, point, body2, point, Rotation.IDENTITY);
    return switch (k) {
      case 0 -> new Revolute("j0", at, unit(0.1, 1, 0.2), 0, 0, Origin.NONE);
      case 1 -> new Spherical("j1", at, JointStart.atZero(JointType.S), false, Origin.NONE);
      case 2 ->
          new Universal(
              "j2",
              at,
              unit(0, 1, 0.1),
              unit(1, 0, 0.3),
              JointStart.atZero(JointType.U),
              false,
              Origin.NONE);
      default ->
          sliding
              ? new Prismatic("j3", at, unit(1, 0.1, 0.1), 0, 0, Origin.NONE)
              : new Revolute("j3", at, unit(-0.1, 1, 0.3), 0, 0, Origin.NONE);
    };
  }

  /**
   * Returns the loop.
   *
   * @param cut which of the four joints is cut
   * @param sliding whether the last joint slides instead of turning
   */
  static Mechanism cutAt(int cut, boolean sliding, List<ForceElement> forces) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> tree = new ArrayList<>();
    List<LoopClosure> closures = new ArrayList<>();
    for (int k = 0; k < JOINTS; k++) {
      Joint joint = joint(k, sliding);
      if (k == cut) {
        closures.add(new JointClosure(joint));
      } else {
        tree.add(k < cut ? joint : joint.reversed());
      }
      if (k < JOINTS - 1) {
        Vector3 middle = POINTS[k].plus(POINTS[k + 1]).times(0.5);
        InertiaTensor inertia = new InertiaTensor(0.02, 0.03, 0.025, 0.002, -0.001, 0.003);
        bodies.add(new Body("b" + k, 1 + k, middle, inertia, Origin.NONE));
      }
    }
    return new Mechanism(
        "loop cut at " + cut,
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        GRAVITY,
        bodies,
        tree,
        List.of(),
        Collections.nCopies(tree.size(), StartRole.PREFERRED),
        closures,
        forces,
        List.of());
  }
}
