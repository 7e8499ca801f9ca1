package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.mechml.resolve.body.BodyIndex;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Root;

/** Reads {@code Joints} with the starts that {@code relCoorVals} gives them. */
public final class JointsReader {
  private final ValueReader values;
  private final JointReader reader;
  private final NameTable<BodyDefinition> bodies;
  private final BodyIndex index;
  private final Diagnostics diagnostics;

  public JointsReader(
      ValueReader values,
      NameTable<BodyDefinition> bodies,
      BodyIndex index,
      Diagnostics diagnostics) {
    this.values = values;
    this.reader = new JointReader(values, diagnostics);
    this.bodies = bodies;
    this.index = index;
    this.diagnostics = diagnostics;
  }

  /** Returns the joints whose two bodies exist, in file order. */
  public List<JointLink> read(List<Element> joints, List<Element> jointVals) {
    NameTable<Element> names = new NameTable<>("joint", "does not exist", diagnostics);
    joints.forEach(joint -> names.add(joint, Optional.of(joint)));
    Map<String, Element> starts = starts(jointVals, names);
    List<JointLink> links = new ArrayList<>();
    for (Element joint : joints) {
      link(joint, Optional.ofNullable(starts.get(joint.required("name")))).ifPresent(links::add);
    }
    return links;
  }

  private Map<String, Element> starts(List<Element> jointVals, NameTable<Element> joints) {
    Map<String, Element> starts = new HashMap<>();
    for (Element jointVal : jointVals) {
      String name = jointVal.required("name");
      Element first = starts.putIfAbsent(name, jointVal);
      if (first != null) {
        diagnostics.error(
            MessageCode.DUPLICATE_NAME,
            jointVal.position(),
            Phrase.of(
                "%s: %s already gives the start of this joint",
                jointVal.label(), first.position().inWords()));
      } else {
        joints.find(jointVal, name);
      }
    }
    return starts;
  }

  /**
   * Returns the joints with those placed in the world read, too.
   *
   * @param read joints that {@link #read} gave
   * @param tree of them
   * @param root pose of the root
   */
  public List<JointLink> placed(List<JointLink> read, JointTree tree, Root root) {
    if (read.stream().noneMatch(link -> WorldJoints.isPlacedInWorld(link.element()))) {
      return read;
    }
    WorldJoints world = new WorldJoints(read, tree, values, diagnostics);
    Map<Integer, AssemblyPose> poses = world.poses(root);
    List<JointLink> placed = new ArrayList<>();
    for (JointLink link : read) {
      placed.add(WorldJoints.isPlacedInWorld(link.element()) ? placed(link, world, poses) : link);
    }
    return placed;
  }

  private JointLink placed(JointLink link, WorldJoints world, Map<Integer, AssemblyPose> poses) {
    AssemblyPose pose1 = poses.get(link.body1());
    AssemblyPose pose2 = poses.get(link.body2());
    if (pose1 == null || pose2 == null) {
      return link;
    }
    return new JointLink(
        link.element(),
        link.start(),
        link.body1(),
        link.body2(),
        reader.read(
            link.element(),
            link.type(),
            link.start(),
            diagnostics.origin(link.element().position()),
            world.placement(
                link.element(), Map.entry(link.body1(), pose1), Map.entry(link.body2(), pose2))));
  }

  /** Returns a joint that is placed in the world, as yet unread; reports unknown bodies. */
  private Optional<JointLink> inWorld(Element element, Optional<Element> start) {
    if (element.attribute("body1").isEmpty() || element.attribute("body2").isEmpty()) {
      diagnostics.error(
          MessageCode.JOINT_PLACE,
          element.position(),
          element.label()
              + ": it holds <body1> and <body2>, or has attributes body1 and body2 with at and axis"
              + " in the world");
      return Optional.empty();
    }
    Optional<BodyDefinition> first = bodies.find(element, element.required("body1"));
    Optional<BodyDefinition> second = bodies.find(element, element.required("body2"));
    return first.isPresent() && second.isPresent()
        ? Optional.of(
            new JointLink(
                element, start, index.of(first.get()), index.of(second.get()), Optional.empty()))
        : Optional.empty();
  }

  /** Reports attributes of a placement in the world beside points in the bodies. */
  private void refuseBoth(Element element) {
    for (String attribute : List.of("body1", "body2", "at", "axis", "axis2")) {
      if (element.attribute(attribute).isPresent()) {
        diagnostics.error(
            MessageCode.JOINT_PLACE,
            element.position(),
            Phrase.of(
                "%s: %s places it in the world, but <body1> and <body2> place it in the bodies;"
                    + " write one of the two",
                element.label(), attribute));
        return;
      }
    }
  }

  /** Returns a joint, or the joint whose equations a constraint has; reports unknown bodies. */
  Optional<JointLink> link(Element element, Optional<Element> start) {
    if (WorldJoints.isPlacedInWorld(element)) {
      return inWorld(element, start);
    }
    refuseBoth(element);
    Optional<BodyEnd> end1 = end(element.requiredChild("body1"));
    Optional<BodyEnd> end2 = end(element.requiredChild("body2"));
    if (end1.isEmpty() || end2.isEmpty()) {
      return Optional.empty();
    }
    JointInput input =
        new JointInput(
            element,
            end1.get(),
            end2.get(),
            index.of(end1.get().body()),
            index.of(end2.get().body()),
            start,
            diagnostics.origin(element.position()));
    return Optional.of(
        new JointLink(element, start, input.body1(), input.body2(), reader.read(input)));
  }

  private Optional<BodyEnd> end(Element element) {
    return bodies.find(element, element.required("name")).map(body -> new BodyEnd(element, body));
  }
}
