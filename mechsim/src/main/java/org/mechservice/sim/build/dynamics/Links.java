package org.mechservice.sim.build.dynamics;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
 * A mechanism in computing frames.
 *
 * @param mechanism what it describes
 * @param links bodies with their joints from the root outwards: parents come before their children
 * @param gravity acceleration of free fall in root axes, m/s²
 */
public record Links(Mechanism mechanism, List<Link> links, Vector3 gravity) {
  /** Index of the root where a link is meant. */
  public static final int ROOT = -1;

  /** Chooses the computing frames of a mechanism. */
  public static Links of(Mechanism mechanism) {
    Labels bodyLabels = new Labels();
    Labels jointLabels = new Labels();
    List<Link> links = new ArrayList<>();
    Map<Integer, Integer> linkOfBody = new HashMap<>();
    linkOfBody.put(Mechanism.ROOT, ROOT);
    for (int joint : mechanism.outward()) {
      Attachment attachment = mechanism.joints().get(joint).attachment();
      int parent = linkOfBody.getOrDefault(attachment.parent(), ROOT);
      Rotation fromParentBody = parent == ROOT ? Rotation.IDENTITY : links.get(parent).fromBody();
      Rotation frame = ComputingAxes.of(mechanism, joint, fromParentBody);
      linkOfBody.put(attachment.child(), links.size());
      links.add(link(mechanism, joint, parent, fromParentBody, frame, bodyLabels, jointLabels));
    }
    Rotation toRoot = mechanism.root().orientation().transposed();
    return new Links(mechanism, List.copyOf(links), toRoot.apply(mechanism.gravity()));
  }

  private static Link link(
      Mechanism mechanism,
      int index,
      int parent,
      Rotation fromParentBody,
      Rotation frame,
      Labels bodyLabels,
      Labels jointLabels) {
    Joint joint = mechanism.joints().get(index);
    Attachment attachment = joint.attachment();
    Body body = mechanism.bodies().get(attachment.child());
    Vector3 origin = frame.apply(attachment.childPoint().negated());
    Rotation toParent = fromParentBody.times(attachment.zeroRotation()).times(frame.transposed());
    return new Link(
        parent,
        attachment.child(),
        index,
        joint.type(),
        mechanism.positionOffset(index),
        mechanism.positionCount() + mechanism.velocityOffset(index),
        offset(mechanism, attachment, fromParentBody),
        AxesChange.of(toParent),
        frame,
        Axes.snapped(attachment.zeroRotation()),
        Axes.snapped(attachment.zeroRotation().transposed().apply(axisOf(joint))),
        origin,
        body.mass(),
        ComputingAxes.inFrame(frame, body.centerOfMass().minus(attachment.childPoint())),
        ComputingAxes.inFrame(frame, body.inertia()),
        initialPosition(joint),
        bodyLabels.labelOf(body.name()),
        jointLabels.labelOf(joint.name()),
        "body " + body.name() + " on joint " + joint.name() + " (" + joint.type() + ")");
  }

  /** Returns the joint's point on the parent from the parent's computing origin. */
  private static Vector3 offset(
      Mechanism mechanism, Attachment attachment, Rotation fromParentBody) {
    Vector3 parentOrigin =
        attachment.parent() == Mechanism.ROOT
            ? Vector3.ZERO
            : mechanism
                .joints()
                .get(mechanism.jointOf(attachment.parent()))
                .attachment()
                .childPoint();
    return ComputingAxes.inFrame(fromParentBody, attachment.parentPoint().minus(parentOrigin));
  }

  /** Returns the axis of a joint in the axes of its parent body. */
  static Vector3 axisOf(Joint joint) {
    if (joint instanceof Revolute revolute) {
      return revolute.axis();
    }
    return ((Prismatic) joint).axis();
  }

  private static double initialPosition(Joint joint) {
    double[] q = new double[joint.type().positionCount()];
    joint.initialPositions(q, 0);
    return q[0];
  }

  /** Returns the tensor of inertia about a point of a body from that about its centre of mass. */
  static InertiaTensor about(double mass, Vector3 c, InertiaTensor inertia) {
    return new InertiaTensor(
        inertia.xx() + mass * (c.y() * c.y() + c.z() * c.z()),
        inertia.yy() + mass * (c.x() * c.x() + c.z() * c.z()),
        inertia.zz() + mass * (c.x() * c.x() + c.y() * c.y()),
        inertia.xy() - mass * c.x() * c.y(),
        inertia.xz() - mass * c.x() * c.z(),
        inertia.yz() - mass * c.y() * c.z());
  }
}
