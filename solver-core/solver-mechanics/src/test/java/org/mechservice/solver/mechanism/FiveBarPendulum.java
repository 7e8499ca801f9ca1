package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * The paper's pendulum: five slender bars of 1 m and 1 kg, straight along +x, at rest, on turning
 * joints skew to each other.
 *
 * <pre>
 *   ground --j1(y)-- bar1 --j2(y z)-- bar2 --j3(y)-- bar3 --j4(-y z)-- bar4 --j5(y)-- bar5
 * </pre>
 */
public final class FiveBarPendulum {
  private FiveBarPendulum() {}

  /** Returns the pendulum. */
  public static Mechanism mechanism() {
    double[][] axes = {{0, 1, 0}, {0, 0.6, 0.8}, {0, 1, 0}, {0, -0.6, 0.8}, {0, 1, 0}};
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < axes.length; i++) {
      bodies.add(
          new Body(
              "bar" + (i + 1),
              1,
              new Vector3(0.5, 0, 0),
              new InertiaTensor(0, 1.0 / 12, 1.0 / 12, 0, 0, 0),
              Origin.NONE));
      Vector3 onParent = i == 0 ? Vector3.ZERO : new Vector3(1, 0, 0);
      Vector3 axis = new Vector3(axes[i][0], axes[i][1], axes[i][2]);
      Attachment attachment = new Attachment(i - 1, onParent, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("j" + (i + 1), attachment, axis, 0, 0, Origin.NONE));
    }
    Root root = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("FiveBarPendulum", root, new Vector3(0, 0, -9.81), bodies, joints);
  }
}
