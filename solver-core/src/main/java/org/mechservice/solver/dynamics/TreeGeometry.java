package org.mechservice.solver.dynamics;

import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Prismatic;
import org.mechservice.solver.mechanism.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A mechanism's constants as flat arrays, in the form the recursions use them: one link per joint,
 * from the root outwards, each body referred to the joint's point on it (its reference point) and
 * to its own axes.
 *
 * <p>Reference points lie on the bodies, not at the world origin: sums and differences then keep
 * their digits however far away the mechanism is (NUMERICS §1). Immutable.
 */
final class TreeGeometry {
  /** Parent link of the links that hang on the root. */
  static final int ROOT = -1;

  final int linkCount;

  /** Parent link, or {@link #ROOT}; always smaller than the link's own index. */
  final int[] parent;

  /** Index of the link's joint in state order. */
  final int[] joint;

  /** Whether the joint slides; otherwise it turns. */
  final boolean[] slides;

  /** Where the link's coordinate stands in q and in v. */
  final int[] coordinate;

  /** Unit axis in child axes and in parent axes, 3 per link. */
  final double[] axisInChild;

  final double[] axisInParent;

  /** Rotation at zero, child to parent axes, row by row, 9 per link. */
  final double[] zeroRotation;

  /**
   * The joint's point on the parent, from the parent's reference point, in parent axes, m, 3 per
   * link.
   */
  final double[] offset;

  /** Mass, kg. */
  final double[] mass;

  /** Centre of mass from the reference point, in body axes, m, 3 per link. */
  final double[] centerOfMass;

  /** Inertia about the centre of mass in body axes, kg·m²: xx, yy, zz, xy, xz, yz, 6 per link. */
  final double[] inertia;

  /** The file's body origin from the reference point, in body axes, m, 3 per link. */
  final double[] bodyOrigin;

  /** Link of each body, in file order. */
  final int[] linkOfBody;

  TreeGeometry(Mechanism mechanism) {
    int[] outward = mechanism.outward();
    linkCount = outward.length;
    parent = new int[linkCount];
    joint = outward;
    slides = new boolean[linkCount];
    coordinate = new int[linkCount];
    axisInChild = new double[3 * linkCount];
    axisInParent = new double[3 * linkCount];
    zeroRotation = new double[9 * linkCount];
    offset = new double[3 * linkCount];
    mass = new double[linkCount];
    centerOfMass = new double[3 * linkCount];
    inertia = new double[6 * linkCount];
    bodyOrigin = new double[3 * linkCount];
    linkOfBody = new int[mechanism.bodies().size()];
    for (int link = 0; link < linkCount; link++) {
      fill(link, mechanism);
    }
  }

  private void fill(int link, Mechanism mechanism) {
    Joint description = mechanism.joints().get(joint[link]);
    Attachment attachment = description.attachment();
    linkOfBody[attachment.child()] = link;
    coordinate[link] = mechanism.velocityOffset(joint[link]);
    boolean onRoot = attachment.parent() == Mechanism.ROOT;
    parent[link] = onRoot ? ROOT : linkOfBody[attachment.parent()];
    Vector3 parentReference =
        onRoot
            ? Vector3.ZERO
            : mechanism
                .joints()
                .get(mechanism.jointOf(attachment.parent()))
                .attachment()
                .childPoint();
    put(offset, 3 * link, attachment.parentPoint().minus(parentReference));
    put(bodyOrigin, 3 * link, attachment.childPoint().negated());
    Rotation zero = attachment.zeroRotation();
    put(zeroRotation, 9 * link, new Vector3(zero.xx(), zero.xy(), zero.xz()));
    put(zeroRotation, 9 * link + 3, new Vector3(zero.yx(), zero.yy(), zero.yz()));
    put(zeroRotation, 9 * link + 6, new Vector3(zero.zx(), zero.zy(), zero.zz()));
    Vector3 axis = axis(description);
    slides[link] = description instanceof Prismatic;
    put(axisInParent, 3 * link, axis);
    put(axisInChild, 3 * link, zero.transposed().apply(axis));
    Body body = mechanism.bodies().get(attachment.child());
    mass[link] = body.mass();
    put(centerOfMass, 3 * link, body.centerOfMass().minus(attachment.childPoint()));
    InertiaTensor tensor = body.inertia();
    put(inertia, 6 * link, new Vector3(tensor.xx(), tensor.yy(), tensor.zz()));
    put(inertia, 6 * link + 3, new Vector3(tensor.xy(), tensor.xz(), tensor.yz()));
  }

  private static Vector3 axis(Joint joint) {
    if (joint instanceof Revolute revolute) {
      return revolute.axis();
    }
    return ((Prismatic) joint).axis();
  }

  private static void put(double[] target, int at, Vector3 v) {
    target[at] = v.x();
    target[at + 1] = v.y();
    target[at + 2] = v.z();
  }
}
