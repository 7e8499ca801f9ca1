package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.FileShape;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.OwnShape;
import org.mechservice.robot.Robot.Shape;
import org.mechservice.robot.Robot.Visual;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/** Reads the elements of a robot. */
final class UrdfReader {
  /** A link that joints may name as their parent though the file has none such, as in Drake. */
  private static final String WORLD = "world";

  private static final List<String> MOMENTS = List.of("ixx", "iyy", "izz", "ixy", "ixz", "iyz");

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotNumbers numbers;
  private final UrdfJointReader joints;
  private final RobotFiles files;

  /** Colours of the robot's materials, and of those that visuals define. */
  private final Map<String, Element> materials = new HashMap<>();

  /**
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that MechML cannot express
   */
  UrdfReader(RobotFiles files, Diagnostics diagnostics, ImportLosses losses) {
    this.files = files;
    this.diagnostics = diagnostics;
    this.losses = losses;
    numbers = new RobotNumbers(diagnostics);
    joints = new UrdfJointReader(numbers, diagnostics, losses);
  }

  /** Returns the robot without the elements in error. */
  Robot read(Element robot) {
    FormatTable table = FormatTable.of(RobotFormat.URDF);
    table.checkNames(robot, diagnostics, losses);
    table.reportLosses(robot, losses);
    noteMaterials(robot);
    List<Link> links = new ArrayList<>();
    List<Joint> read = new ArrayList<>();
    Map<String, Double> armatures = new HashMap<>();
    Set<String> linkNames = new HashSet<>();
    Set<String> jointNames = new HashSet<>();
    for (Element child : robot.children()) {
      switch (child.name()) {
        case "link" -> {
          if (isNamedAnew(child, linkNames)) {
            links.add(link(child));
          }
        }
        case "joint" -> {
          if (isNamedAnew(child, jointNames)) {
            joints.read(child).ifPresent(read::add);
          }
        }
        case "transmission" -> noteArmature(child, armatures);
        default -> {
          // The table of the format says what else there may be.
        }
      }
    }
    if (links.isEmpty()) {
      numbers.missing(robot, "links");
    }
    read.stream()
        .filter(joint -> joint.parent().equals(WORLD) && linkNames.add(WORLD))
        .findFirst()
        .ifPresent(joint -> links.add(0, new Link(joint.element(), WORLD, Optional.empty())));
    return new Robot(
        RobotFormat.URDF,
        robot.attribute("name").orElse("robot"),
        Optional.empty(),
        links,
        read.stream()
            .map(
                joint ->
                    joint.with(joint.coordinate().armed(armatures.getOrDefault(joint.name(), 0.0))))
            .toList());
  }

  /** Notes the inertia of a motor behind its gear, which Drake adds to URDF. */
  private void noteArmature(Element transmission, Map<String, Double> armatures) {
    for (Element motor : transmission.children("actuator")) {
      double ratio =
          motor.child("drake:gear_ratio").map(one -> numbers.required(one, "value")).orElse(1.0);
      motor
          .child("drake:rotor_inertia")
          .ifPresent(
              rotor ->
                  transmission
                      .child("joint")
                      .flatMap(joint -> joint.attribute("name"))
                      .ifPresent(
                          name ->
                              armatures.merge(
                                  name,
                                  ratio * ratio * numbers.required(rotor, "value"),
                                  Double::sum)));
    }
  }

  private void noteMaterials(Element around) {
    for (Element child : around.children()) {
      if (child.name().equals("material")) {
        child
            .child("color")
            .ifPresent(c -> child.attribute("name").ifPresent(name -> materials.put(name, c)));
      } else if (child.name().equals("link") || child.name().equals("visual")) {
        noteMaterials(child);
      }
    }
  }

  private boolean isNamedAnew(Element element, Set<String> taken) {
    Optional<String> name = element.attribute("name");
    if (name.isEmpty()) {
      numbers.missing(element, "attribute name");
    } else if (!taken.add(name.get())) {
      diagnostics.error(
          MessageCode.DUPLICATE_NAME,
          element.position(),
          Phrase.of(
              "another %s has the name %s; give each its own",
              element.name(), Quoted.of(name.get())));
      return false;
    }
    return name.isPresent();
  }

  private Link link(Element element) {
    numbers.requireOnce(element, List.of("inertial"));
    return new Link(
        element,
        element.required("name"),
        element.child("inertial").flatMap(this::inertial),
        visuals(element));
  }

  private Optional<Inertial> inertial(Element element) {
    numbers.requireOnce(element, List.of("origin", "mass", "inertia"));
    Optional<Element> mass = element.child("mass");
    Optional<Element> inertia = element.child("inertia");
    if (mass.isEmpty()) {
      numbers.missing(element, "mass");
    }
    if (inertia.isEmpty()) {
      numbers.missing(element, "inertia");
    }
    if (mass.isEmpty() || inertia.isEmpty()) {
      return Optional.empty();
    }
    List<Double> moments =
        MOMENTS.stream().map(name -> numbers.required(inertia.get(), name)).toList();
    return Optional.of(
        new Inertial(
            element, numbers.origin(element), numbers.required(mass.get(), "value"), moments));
  }

  /** Returns what a link looks like. */
  private List<Visual> visuals(Element link) {
    List<Visual> all = new ArrayList<>();
    for (Element visual : link.children("visual")) {
      Optional<Element> geometry = visual.child("geometry");
      Optional<Shape> shape =
          geometry.flatMap(one -> one.children().stream().findFirst()).map(this::shape);
      shape.ifPresent(
          one -> all.add(new Visual(visual, numbers.origin(visual), one, colour(visual))));
    }
    return all;
  }

  private Shape shape(Element one) {
    double radius = numbers.optional(one, "radius", 0);
    double length = numbers.optional(one, "length", 0);
    return switch (one.name()) {
      case "box" -> new OwnShape(Surfaces.box(numbers.vector(one, "size", Vector3.ZERO)));
      case "sphere" -> new OwnShape(Surfaces.ellipsoid(new Vector3(radius, radius, radius)));
      case "cylinder" -> new OwnShape(Surfaces.cylinder(radius, length));
      case "capsule" -> new OwnShape(Surfaces.capsule(radius, length));
      default -> {
        String name = one.attribute("filename").map(String::strip).orElse("");
        yield new FileShape(
            name,
            files.folder().flatMap(folder -> files.find(name, folder)),
            numbers.vector(one, "scale", new Vector3(1, 1, 1)));
      }
    };
  }

  /** The colour of a visual is its own, or that of the robot's material of this name. */
  private Optional<List<Double>> colour(Element visual) {
    Optional<Element> material = visual.child("material");
    Optional<Element> own = material.flatMap(one -> one.child("color"));
    return own.or(
            () ->
                material
                    .flatMap(one -> one.attribute("name"))
                    .flatMap(name -> Optional.ofNullable(materials.get(name))))
        .flatMap(
            colour ->
                colour.attribute("rgba").map(text -> numbers.read(colour, "rgba", text, 4, 4)));
  }
}
