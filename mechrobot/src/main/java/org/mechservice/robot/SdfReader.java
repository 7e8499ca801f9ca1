package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Place;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads the models of an SDF file: one model, or all models of a world, with nested models. A link
 * that is no joint's child is free, and at rest in the world if its model is static.
 *
 * <p>Source: the specification at sdformat.org, versions 1.4 to 1.12.
 */
final class SdfReader {
  private static final List<String> MOMENTS = List.of("ixx", "iyy", "izz", "ixy", "ixz", "iyz");
  private static final Set<String> OF_MODEL =
      Set.of("link", "joint", "frame", "model", "pose", "static");
  private static final Set<String> OF_LINK =
      Set.of("inertial", "visual", "collision", "pose", "gravity", "self_collide");

  /** SDF's value of what a file leaves out: a link without inertial has a mass of 1 kg. */
  private static final List<Double> UNIT_MOMENTS = List.of(1.0, 1.0, 1.0, 0.0, 0.0, 0.0);

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotNumbers numbers;
  private final SdfFrames frames;
  private final List<Link> links = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();
  private final Set<String> fixed = new HashSet<>();
  private boolean axesOfModel;

  /**
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that MechML cannot express
   */
  SdfReader(Diagnostics diagnostics, ImportLosses losses) {
    this.diagnostics = diagnostics;
    this.losses = losses;
    numbers = new RobotNumbers(diagnostics);
    frames = new SdfFrames(diagnostics, numbers);
  }

  /** Returns the robot without the elements in error. */
  Robot read(Element sdf) {
    axesOfModel = sdf.attribute("version").filter(v -> v.matches("1\\.[0-4]")).isPresent();
    Element scene = sdf.child("world").orElse(sdf);
    List<Element> models = scene.children("model");
    scene.children().stream()
        .filter(child -> !Set.of("model", "gravity").contains(child.name()))
        .forEach(child -> losses.add(child, "has no meaning in MechML and is left out"));
    if (models.isEmpty()) {
      numbers.missing(scene, "models");
    }
    links.add(new Link(sdf, SdfFrames.WORLD, Optional.empty(), Optional.empty()));
    boolean several = models.size() > 1;
    for (Element model : models) {
      String name = model.attribute("name").orElse("model");
      frames.addModel(several ? name + SdfFrames.SCOPE : "", "", model);
    }
    for (Element model : models) {
      String name = model.attribute("name").orElse("model");
      readModel(several ? name + SdfFrames.SCOPE : "", model, false);
    }
    attachFreeLinks();
    return new Robot(
        RobotFormat.SDF,
        models.stream().findFirst().flatMap(m -> m.attribute("name")).orElse("robot"),
        scene.child("gravity").map(gravity -> vector(numbers.text(gravity, 3))),
        links,
        joints);
  }

  private static Vector3 vector(List<Double> xyz) {
    return new Vector3(xyz.get(0), xyz.get(1), xyz.get(2));
  }

  private void readModel(String scope, Element model, boolean inStatic) {
    boolean rests = inStatic || isTrue(model.child("static"));
    model.children().stream()
        .filter(child -> !OF_MODEL.contains(child.name()))
        .forEach(child -> losses.add(child, "has no meaning in MechML and is left out"));
    for (Element link : model.children("link")) {
      link.attribute("name").ifPresent(name -> readLink(scope + name, link, rests));
    }
    for (Element joint : model.children("joint")) {
      joint.attribute("name").ifPresent(name -> readJoint(scope, name, joint));
    }
    for (Element nested : model.children("model")) {
      nested
          .attribute("name")
          .ifPresent(name -> readModel(scope + name + SdfFrames.SCOPE, nested, rests));
    }
  }

  private static boolean isTrue(Optional<Element> flag) {
    return flag.map(Element::text).filter(t -> t.equals("true") || t.equals("1")).isPresent();
  }

  private void readLink(String name, Element link, boolean rests) {
    link.children().stream()
        .filter(child -> !OF_LINK.contains(child.name()))
        .forEach(child -> losses.add(child, "has no meaning in MechML and is left out"));
    link.child("gravity")
        .filter(gravity -> !isTrue(Optional.of(gravity)))
        .ifPresent(gravity -> losses.add(gravity, "in MechML gravity acts on every body"));
    link.child("collision")
        .ifPresent(collision -> losses.add(collision, "collision shapes are left out"));
    Optional<String> mesh =
        link.child("visual")
            .flatMap(visual -> visual.child("geometry"))
            .flatMap(geometry -> geometry.child("mesh"))
            .flatMap(geometry -> geometry.child("uri"))
            .map(Element::text)
            .filter(file -> !file.isEmpty());
    link.child("visual")
        .filter(visual -> mesh.isEmpty() || visual.child("pose").isPresent())
        .ifPresent(
            visual ->
                losses.add(
                    visual,
                    mesh.isEmpty()
                        ? "a shape other than a mesh is left out"
                        : "its pose in the link is left out"));
    links.add(new Link(link, name, Optional.of(inertial(link)), mesh));
    if (rests) {
      fixed.add(name);
    }
  }

  private Inertial inertial(Element link) {
    Optional<Element> found = link.child("inertial");
    if (found.isEmpty()) {
      losses.add(link, "it has no <inertial>: SDF then means 1 kg and 1 kg·m² about each axis");
      return new Inertial(link, Frame.SAME, 1, UNIT_MOMENTS);
    }
    Element inertial = found.get();
    inertial
        .attribute("auto")
        .filter(auto -> auto.equals("true"))
        .ifPresent(auto -> losses.add(inertial, "inertia of its shapes (auto) is not computed"));
    Optional<Element> tensor = inertial.child("inertia");
    List<Double> moments = new ArrayList<>();
    for (int i = 0; i < MOMENTS.size(); i++) {
      double otherwise = UNIT_MOMENTS.get(i);
      String moment = MOMENTS.get(i);
      moments.add(tensor.map(t -> numbers.text(t, moment, otherwise)).orElse(otherwise));
    }
    return new Inertial(
        inertial, frames.pose(inertial.child("pose")), numbers.text(inertial, "mass", 1), moments);
  }

  private void readJoint(String scope, String name, Element element) {
    Optional<String> parent = end(scope, element, "parent");
    Optional<String> child = end(scope, element, "child");
    String type = element.attribute("type").map(String::strip).orElse("");
    if (parent.isEmpty() || child.isEmpty()) {
      return;
    }
    if (child.get().equals(SdfFrames.WORLD)) {
      diagnostics.error(
          MessageCode.ROBOT_JOINT,
          element.position(),
          Phrase.of("%s: its child is the world; exchange parent and child", element.label()));
      return;
    }
    Frame above = frames.inWorld(parent.get());
    Frame below = frames.inWorld(child.get());
    Frame childInParent = above.inverse().times(below);
    Frame jointInChild = below.inverse().times(frames.inWorld(scope + name));
    switch (type) {
      case "fixed" ->
          joints.add(
              new Joint(
                  element,
                  scope + name,
                  Freedom.FIXED,
                  parent.get(),
                  child.get(),
                  Place.at(childInParent, new Vector3(1, 0, 0)),
                  Coordinate.FREE));
      case "ball" ->
          joints.add(
              new Joint(
                  element,
                  scope + name,
                  Freedom.SPHERICAL,
                  parent.get(),
                  child.get(),
                  Place.along(childInParent, jointInChild.at(), new Vector3(1, 0, 0)),
                  Coordinate.FREE));
      case "revolute", "continuous", "prismatic", "screw" -> {
        Element axis = axis(element, "axis");
        SdfAxis read = new SdfAxis(axis, numbers, losses);
        Freedom freedom =
            switch (type) {
              case "prismatic" -> Freedom.PRISMATIC;
              case "screw" -> Freedom.SCREW;
              default -> Freedom.REVOLUTE;
            };
        Place place =
            new Place(
                childInParent,
                jointInChild.at(),
                direction(scope, name, axis, below),
                freedom == Freedom.SCREW ? lead(element) : 0);
        joints.add(
            new Joint(
                element,
                scope + name,
                freedom,
                parent.get(),
                child.get(),
                place,
                read.coordinate(type.equals("continuous"))));
      }
      case "universal", "revolute2" -> {
        // Two hinges with a cross without mass between them.
        String cross = scope + name + "_cross";
        Element first = axis(element, "axis");
        Element second = axis(element, "axis2");
        links.add(new Link(element, cross, Optional.empty(), Optional.empty()));
        joints.add(
            new Joint(
                element,
                scope + name,
                Freedom.REVOLUTE,
                parent.get(),
                cross,
                Place.along(childInParent, jointInChild.at(), direction(scope, name, first, below)),
                new SdfAxis(first, numbers, losses).coordinate(false)));
        joints.add(
            new Joint(
                element,
                scope + name + "_2",
                Freedom.REVOLUTE,
                cross,
                child.get(),
                Place.along(Frame.SAME, jointInChild.at(), direction(scope, name, second, below)),
                new SdfAxis(second, numbers, losses).coordinate(false)));
      }
      default ->
          diagnostics.error(
              MessageCode.VALUE_NOT_IN_LIST,
              element.position(),
              Phrase.of(
                  "%s: type is %s; the import knows revolute, continuous, prismatic, fixed, ball,"
                      + " universal, revolute2, screw",
                  element.label(), Quoted.of(type)));
    }
  }

  /** Returns the link that an end of a joint names, directly or by a frame attached to it. */
  private Optional<String> end(String scope, Element joint, String end) {
    Optional<Element> found = joint.child(end);
    if (found.isEmpty() || found.get().text().isEmpty()) {
      numbers.missing(joint, end);
      return Optional.empty();
    }
    return frames.link(scope, found.get().text(), joint);
  }

  private Element axis(Element joint, String name) {
    Optional<Element> axis = joint.child(name);
    if (axis.isEmpty()) {
      numbers.missing(joint, name);
    }
    return axis.orElse(joint);
  }

  /** Returns the axis in the child's axes. */
  private Vector3 direction(String scope, String joint, Element axis, Frame child) {
    Optional<Element> xyz = axis.child("xyz");
    Vector3 given = xyz.map(found -> vector(numbers.text(found, 3))).orElse(new Vector3(0, 0, 1));
    if (!(given.norm() > 0)) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          xyz.orElse(axis).position(),
          Phrase.of("%s: it is zero and has no direction", xyz.orElse(axis).label()));
      return new Vector3(0, 0, 1);
    }
    String base =
        xyz.flatMap(found -> found.attribute("expressed_in"))
            .orElse(
                axesOfModel || isTrue(axis.child("use_parent_model_frame"))
                    ? SdfFrames.MODEL
                    : joint);
    Frame frame = frames.named(scope, base, axis);
    return child.turn().transposed().apply(frame.turn().apply(given)).normalized();
  }

  private double lead(Element joint) {
    if (joint.child("screw_thread_pitch").isEmpty()) {
      numbers.missing(joint, "screw_thread_pitch, the advance in one turn");
    }
    return numbers.text(joint, "screw_thread_pitch", 1);
  }

  private void attachFreeLinks() {
    Set<String> held = new HashSet<>(Set.of(SdfFrames.WORLD));
    joints.forEach(joint -> held.add(joint.child()));
    for (Link link : List.copyOf(links)) {
      if (!held.contains(link.name())) {
        Freedom freedom = fixed.contains(link.name()) ? Freedom.FIXED : Freedom.FLOATING;
        joints.add(
            new Joint(
                link.element(),
                link.name() + (freedom == Freedom.FIXED ? "_rest" : "_free"),
                freedom,
                SdfFrames.WORLD,
                link.name(),
                Place.at(frames.inWorld(link.name()), new Vector3(1, 0, 0)),
                Coordinate.FREE));
      }
    }
  }
}
