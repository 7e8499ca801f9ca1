package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads the elements of a robot. */
final class UrdfReader {
  private static final List<String> MOMENTS = List.of("ixx", "iyy", "izz", "ixy", "ixz", "iyz");

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotNumbers numbers;
  private final UrdfJointReader joints;

  /**
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that MechML cannot express
   */
  UrdfReader(Diagnostics diagnostics, ImportLosses losses) {
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
    List<Link> links = new ArrayList<>();
    List<Joint> read = new ArrayList<>();
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
        default -> {
          // The table of the format says what else there may be.
        }
      }
    }
    if (links.isEmpty()) {
      numbers.missing(robot, "links");
    }
    return new Robot(
        RobotFormat.URDF, robot.attribute("name").orElse("robot"), Optional.empty(), links, read);
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
        mesh(element));
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

  /** Returns the mesh of a link; a picture of a body is one file, in the body's frame and size. */
  private Optional<String> mesh(Element link) {
    List<Element> visuals = link.children("visual");
    if (visuals.isEmpty()) {
      return Optional.empty();
    }
    Element visual = visuals.get(0);
    Optional<Element> mesh = visual.child("geometry").flatMap(geometry -> geometry.child("mesh"));
    Optional<String> file = mesh.flatMap(m -> m.attribute("filename")).map(String::strip);
    List<String> lost = new ArrayList<>();
    if (file.isEmpty()) {
      lost.add("a shape other than a mesh");
    } else if (mesh.flatMap(m -> m.attribute("scale")).isPresent()) {
      lost.add("the mesh's scale");
    }
    if (visual.child("origin").map(Element::attributes).filter(a -> !isZero(a)).isPresent()) {
      lost.add("its pose in the link");
    }
    if (visual.child("material").isPresent()) {
      lost.add("its material");
    }
    if (visuals.size() > 1) {
      lost.add(visuals.size() - 1 + " further visual" + (visuals.size() > 2 ? "s" : ""));
    }
    if (!lost.isEmpty()) {
      losses.picture(
          visual,
          lost.stream().collect(Collectors.joining(", "))
              + (lost.size() > 1 ? " are" : " is")
              + " left out");
    }
    return file.filter(name -> !name.isEmpty());
  }

  private static boolean isZero(List<Attribute> origin) {
    return origin.stream().allMatch(a -> a.value().matches("[\\s+\\-0.]*"));
  }
}
