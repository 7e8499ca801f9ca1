package org.mechservice.mechml.resolve.joint;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.AlignmentRotation;
import org.mechservice.mechml.resolve.value.DirectionReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Places the joints that are given by a point and an axis in the world at assembly.
 *
 * <p>Assembly is the position of the bodies from which the coordinates of such joints count. The
 * tree leads from the root to every body. A body that the tree reaches by such a joint has its
 * frame in the world's; one that it reaches by a joint with a point in each body is where that
 * joint's start puts it. The joint's point and axes then have coordinates in each of its two
 * bodies.
 */
final class WorldJoints {
  private final List<JointLink> links;
  private final JointTree tree;
  private final ValueReader values;
  private final DirectionReader directions;
  private final Diagnostics diagnostics;

  WorldJoints(List<JointLink> links, JointTree tree, ValueReader values, Diagnostics diagnostics) {
    this.links = links;
    this.tree = tree;
    this.values = values;
    this.directions = new DirectionReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns whether a joint names its bodies in attributes, and is placed in the world. */
  static boolean isPlacedInWorld(Element joint) {
    return joint.child("body1").isEmpty();
  }

  /**
   * Returns the poses of the bodies at assembly in the world by their index, without those behind a
   * joint that could not be read.
   *
   * @param root pose of the root
   */
  Map<Integer, AssemblyPose> poses(Root root) {
    Map<Integer, List<Integer>> linksOf = new HashMap<>();
    for (int j = 0; j < links.size(); j++) {
      if (!tree.isCut(j)) {
        linksOf.computeIfAbsent(links.get(j).body1(), body -> new ArrayList<>()).add(j);
        linksOf.computeIfAbsent(links.get(j).body2(), body -> new ArrayList<>()).add(j);
      }
    }
    Map<Integer, AssemblyPose> poses = new HashMap<>();
    poses.put(Mechanism.ROOT, new AssemblyPose(root.position(), root.orientation()));
    Deque<Integer> front = new ArrayDeque<>(List.of(Mechanism.ROOT));
    while (!front.isEmpty()) {
      int body = front.remove();
      for (int j : linksOf.getOrDefault(body, List.of())) {
        JointLink link = links.get(j);
        boolean forward = link.body1() == body;
        int next = forward ? link.body2() : link.body1();
        Optional<AssemblyPose> pose =
            next(link, forward, poses.getOrDefault(body, AssemblyPose.COINCIDENT));
        if (!poses.containsKey(next) && pose.isPresent()) {
          poses.put(next, pose.get());
          front.add(next);
        }
      }
    }
    return poses;
  }

  private static Optional<AssemblyPose> next(JointLink link, boolean forward, AssemblyPose from) {
    if (isPlacedInWorld(link.element())) {
      return Optional.of(AssemblyPose.COINCIDENT);
    }
    return link.joint()
        .map(AssemblyPose::of)
        .map(pose -> (forward ? pose : pose.reversed()).from(from));
  }

  /**
   * Returns the placement of a joint; empty after a reported error.
   *
   * @param body1 index of its first body, and the pose of that
   * @param body2 index of its second body, and the pose of that
   */
  Optional<AxisReader.Placement> placement(
      Element joint,
      Map.Entry<Integer, AssemblyPose> body1,
      Map.Entry<Integer, AssemblyPose> body2) {
    JointType type = JointType.valueOf(joint.required("type"));
    Optional<Vector3> at = at(joint);
    Optional<Vector3> axis = axis(joint, type, "axis", axisCount(type) > 0);
    Optional<Vector3> axis2 = axis(joint, type, "axis2", axisCount(type) > 1);
    if (at.isEmpty() || axis.isEmpty() || axis2.isEmpty()) {
      return Optional.empty();
    }
    Optional<Vector3> second = across(joint, type, axis.get(), axis2.get());
    if (second.isEmpty()) {
      return Optional.empty();
    }
    AssemblyPose pose1 = body1.getValue();
    AssemblyPose pose2 = body2.getValue();
    Rotation zero = pose1.rotationFrom(pose2);
    Vector3 direction = type == JointType.U ? second.get() : axis.get();
    return Optional.of(
        new AxisReader.Placement(
            new Attachment(
                body1.getKey(),
                pose1.toBody(at.get()),
                body2.getKey(),
                pose2.toBody(at.get()),
                zero),
            pose1.turnedToBody(axis.get()),
            pose2.turnedToBody(direction),
            pose1.turnedToBody(second.get())));
  }

  private static int axisCount(JointType type) {
    return switch (type) {
      case R, P, C, H -> 1;
      case U, PL -> 2;
      case S, F, W -> 0;
    };
  }

  private Optional<Vector3> at(Element joint) {
    return joint.attribute("at").isEmpty()
        ? Optional.of(Vector3.ZERO)
        : values.triple(joint, "at", Quantity.LENGTH);
  }

  private Optional<Vector3> axis(Element joint, JointType type, String attribute, boolean needed) {
    boolean given = joint.attribute(attribute).isPresent();
    if (given && !needed) {
      return error(
          MessageCode.VECTOR_WITHOUT_MEANING,
          joint,
          Phrase.of("%s has no meaning in a joint of type %s", attribute, type));
    }
    if (!given && needed) {
      return error(
          MessageCode.MISSING_VECTOR,
          joint,
          Phrase.of(
              "a joint of type %s needs %s, a direction in the world such as \"0;0;1\"",
              type, attribute));
    }
    return given ? directions.read(joint, attribute) : Optional.of(Vector3.ZERO);
  }

  /** Returns the second axis as the joint needs it: at right angles to the first. */
  private Optional<Vector3> across(Element joint, JointType type, Vector3 axis, Vector3 second) {
    boolean wrong =
        switch (type) {
          case U -> !AlignmentRotation.areOrthogonal(axis, second);
          case PL -> AlignmentRotation.areParallel(axis, second);
          default -> false;
        };
    if (wrong) {
      return error(
          MessageCode.SECOND_VECTOR,
          joint,
          type == JointType.U
              ? "axis2, about which body2 turns, must be at right angles to axis"
              : "axis2, the direction of the first displacement, is parallel to axis");
    }
    return Optional.of(axisCount(type) == 2 ? AlignmentRotation.normalTo(axis, second) : second);
  }

  private <T> Optional<T> error(MessageCode code, Element joint, String message) {
    diagnostics.error(code, joint.position(), joint.label() + ": " + message);
    return Optional.empty();
  }
}
