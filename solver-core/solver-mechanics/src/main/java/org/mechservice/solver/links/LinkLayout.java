package org.mechservice.solver.links;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Lays out the links of a mechanism: one for every elementary link that moves. */
final class LinkLayout {
  private final Mechanism mechanism;
  private final TreeGeometry tree;
  private final RigidGroups groups;
  private final Labels bodyLabels = new Labels();
  private final Labels jointLabels = new Labels();
  private final String[] labelOfBody;
  private final String[] labelOfJoint;
  private final List<Link> links = new ArrayList<>();

  /** Index among the links for each elementary link that moves. */
  private final int[] numberOf;

  private final Rotation[] frames;
  private final int[] stateJoint;

  /** Offsets of the links that move on each elementary link. */
  private final List<List<Vector3>> offsets = new ArrayList<>();

  LinkLayout(TreeGeometry tree) {
    this.mechanism = tree.mechanism();
    this.tree = tree;
    this.groups = new RigidGroups(tree);
    this.numberOf = new int[tree.linkCount];
    this.frames = new Rotation[tree.linkCount];
    this.labelOfBody = new String[mechanism.bodies().size()];
    this.labelOfJoint = new String[mechanism.joints().size()];
    this.stateJoint = new int[mechanism.joints().size()];
    for (int i = 0; i < tree.linkCount; i++) {
      offsets.add(new ArrayList<>());
      int carrier = groups.carrier(tree.parent[i]);
      if (groups.carrier(i) == i && carrier != RigidGroups.ROOT) {
        offsets.get(carrier).add(groups.offsetFromCarrier(i));
      }
    }
    int states = 0;
    for (int j = 0; j < stateJoint.length; j++) {
      stateJoint[j] = mechanism.isDriven(j) ? -1 : states++;
    }
  }

  Links links() {
    for (int joint : mechanism.outward()) {
      int body = mechanism.joints().get(joint).attachment().child();
      labelOfBody[body] = bodyLabels.labelOf(mechanism.bodies().get(body).name());
      labelOfJoint[joint] = jointLabels.labelOf(mechanism.joints().get(joint).name());
    }
    for (int i = 0; i < tree.linkCount; i++) {
      if (tree.kind[i] != LinkKind.FIXED) {
        add(i);
      }
    }
    Rotation toRoot = mechanism.root().orientation().transposed();
    RigidGroups.MassProperties fixed = groups.massOfRoot();
    return new Links(
        mechanism,
        links,
        bodies(),
        tree.statePositionCount,
        tree.stateVelocityCount,
        toRoot.apply(mechanism.gravity()),
        fixed.mass(),
        fixed.center());
  }

  private Rotation frame(int link) {
    return link == RigidGroups.ROOT ? Rotation.IDENTITY : frames[link];
  }

  private void add(int i) {
    int parent = tree.parent[i];
    int carrier = groups.carrier(parent);
    Rotation fromParent = frame(carrier).times(groups.toCarrier(parent));
    boolean ball = tree.kind[i] == LinkKind.BALL;
    Rotation zero = RigidGroups.rotation(tree.zeroRotation, 9 * i);
    frames[i] =
        ball
            ? Rotation.IDENTITY
            : new ComputingAxes(tree, groups, i, offsets.get(i)).choose(fromParent.times(zero));
    Rotation toParent = fromParent.times(zero).times(frames[i].transposed());
    numberOf[i] = links.size();
    links.add(link(i, carrier, toParent));
  }

  private Link link(int i, int carrier, Rotation toParent) {
    Rotation frame = frames[i];
    Rotation zero = RigidGroups.rotation(tree.zeroRotation, 9 * i);
    RigidGroups.MassProperties mass = groups.massOf(i);
    boolean driven = tree.driven[i];
    int joint = tree.joint[i];
    return new Link(
        carrier == RigidGroups.ROOT ? Links.ROOT : numberOf[carrier],
        tree.kind[i],
        joint,
        stateJoint[joint],
        tree.component[i],
        driven ? -1 : tree.positionAt[i],
        driven ? -1 : tree.statePositionCount + tree.velocityAt[i],
        driven ? motion(i) : List.of(),
        tree.kind[i] == LinkKind.SLIDE ? 1 : tree.pitch[i],
        tree.inverse[i],
        offset(i, carrier),
        AxesChange.of(toParent),
        frame,
        Axes.snapped(groups.toCarrier(tree.parent[i]).times(zero)),
        Axes.snapped(RigidGroups.vector(tree.axisInLink, 3 * i)),
        mass.mass(),
        ComputingAxes.inFrame(frame, mass.center()),
        ComputingAxes.inFrame(frame, mass.inertia()),
        tree.armature[tree.velocityAt[i]],
        initialPosition(i),
        bodyLabel(i),
        jointLabel(i),
        title(i));
  }

  /** Returns the joint's point from the parent's computing origin, in its computing axes. */
  private Vector3 offset(int i, int carrier) {
    return ComputingAxes.inFrame(frame(carrier), groups.offsetFromCarrier(i));
  }

  private List<Expression> motion(int i) {
    JointType type = mechanism.joints().get(tree.joint[i]).type();
    int surplus = type.positionCount() - type.velocityCount();
    int at = tree.component[i] + surplus;
    for (PrescribedMotion motion : mechanism.motions()) {
      if (motion.joint() == tree.joint[i]) {
        return tree.kind[i] == LinkKind.BALL
            ? motion.coordinates().subList(0, 4)
            : motion.coordinates().subList(at, at + 1);
      }
    }
    throw new IllegalStateException("a driven joint has no motion");
  }

  private double initialPosition(int i) {
    if (tree.kind[i] == LinkKind.BALL) {
      return 0;
    }
    Joint joint = mechanism.joints().get(tree.joint[i]);
    double[] q = new double[joint.type().positionCount()];
    joint.initialPositions(q, 0);
    int surplus = joint.type().positionCount() - joint.type().velocityCount();
    return q[tree.component[i] + surplus];
  }

  private int bodyAtEnd(int i) {
    return mechanism.joints().get(tree.joint[i]).attachment().child();
  }

  private boolean isWhole(int i) {
    return mechanism.joints().get(tree.joint[i]).type().velocityCount()
        == tree.kind[i].velocityCount();
  }

  private String bodyLabel(int i) {
    String body = labelOfBody[bodyAtEnd(i)];
    return tree.body[i] >= 0 ? body : body + "_in" + tree.component[i];
  }

  private String jointLabel(int i) {
    String joint = labelOfJoint[tree.joint[i]];
    return isWhole(i) ? joint : joint + "_" + tree.component[i];
  }

  private String title(int i) {
    Joint joint = mechanism.joints().get(tree.joint[i]);
    Body body = mechanism.bodies().get(bodyAtEnd(i));
    String onJoint = "joint " + joint.name() + " (" + joint.type() + ")";
    String driven = tree.driven[i] ? ", driven" : "";
    return tree.body[i] >= 0
        ? "body " + body.name() + " on " + onJoint + driven
        : "inside " + onJoint + driven;
  }

  private List<BodyPlacement> bodies() {
    BodyPlacement[] places = new BodyPlacement[tree.linkOfBody.length];
    for (int body = 0; body < places.length; body++) {
      int link = tree.linkOfBody[body];
      int carrier = groups.carrier(link);
      Rotation toCarrier = groups.toCarrier(link);
      Vector3 own = RigidGroups.vector(tree.bodyOrigin, 3 * link);
      Vector3 origin = groups.origin(link).plus(toCarrier.apply(own));
      places[body] =
          new BodyPlacement(
              carrier == RigidGroups.ROOT ? Links.ROOT : numberOf[carrier],
              toCarrier,
              frame(carrier).times(toCarrier),
              frame(carrier).apply(origin),
              labelOfBody[body]);
    }
    return Arrays.asList(places);
  }
}
