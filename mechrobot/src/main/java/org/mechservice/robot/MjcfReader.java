package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.MjcfJointReader.Held;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.robot.Robot.Place;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads a model of MuJoCo: nested bodies, each with the joints to the body around it. Several
 * joints of one body become links without mass between them. Positions count from the pose that the
 * file gives, as MuJoCo's do where {@code ref} is zero.
 *
 * <p>Source: MuJoCo documentation, XML reference.
 */
final class MjcfReader {
  private static final String WORLD = "world";

  /** Sections that say nothing about the motion of the mechanism itself. */
  private static final Set<String> SILENT =
      Set.of(
          "compiler",
          "default",
          "worldbody",
          "option",
          "size",
          "statistic",
          "visual",
          "asset",
          "custom",
          "equality");

  private static final Set<String> OF_BODY =
      Set.of("body", "joint", "freejoint", "inertial", "geom", "frame", "site", "camera", "light");
  private static final Vector3 AXIS = new Vector3(0, 0, 1);

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotNumbers numbers;
  private final List<Link> links = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();
  private final Set<String> linkNames = new HashSet<>();
  private final Set<String> jointNames = new HashSet<>();
  private final Map<String, Element> followers = new LinkedHashMap<>();
  private Optional<Element> shape = Optional.empty();

  /**
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that MechML cannot express
   */
  MjcfReader(Diagnostics diagnostics, ImportLosses losses) {
    this.diagnostics = diagnostics;
    this.losses = losses;
    numbers = new RobotNumbers(diagnostics);
  }

  /** Returns the robot without the elements in error. */
  Robot read(Element mujoco) {
    mujoco.children().stream()
        .filter(section -> !SILENT.contains(section.name()))
        .forEach(section -> losses.add(section, "has no meaning in MechML and is left out"));
    noteSettings(mujoco);
    readEqualities(mujoco);
    Optional<Element> world = mujoco.child("worldbody");
    if (world.isEmpty()) {
      numbers.missing(mujoco, "worldbody");
    }
    links.add(new Link(world.orElse(mujoco), WORLD, Optional.empty(), Optional.empty()));
    linkNames.add(WORLD);
    Bodies bodies = new Bodies(mujoco);
    world.ifPresent(bodies::readWorld);
    shape.ifPresent(
        geometry ->
            losses.add(geometry, "contacts between shapes are left out, here and elsewhere"));
    return new Robot(
        RobotFormat.MJCF,
        mujoco.attribute("model").orElse("robot"),
        Optional.of(gravity(mujoco)),
        scaled(mujoco),
        joints.stream().map(this::following).toList());
  }

  /** Returns the links with the total mass that {@code settotalmass} asks for, if any. */
  private List<Link> scaled(Element mujoco) {
    double wished = 0;
    for (Element compiler : mujoco.children("compiler")) {
      wished = numbers.optional(compiler, "settotalmass", wished);
    }
    double total =
        links.stream().flatMap(link -> link.inertial().stream()).mapToDouble(Inertial::mass).sum();
    if (!(wished > 0) || !(total > 0)) {
      return links;
    }
    double factor = wished / total;
    return links.stream()
        .map(
            link ->
                new Link(
                    link.element(),
                    link.name(),
                    link.inertial()
                        .map(
                            inertial ->
                                new Inertial(
                                    inertial.element(),
                                    inertial.frame(),
                                    factor * inertial.mass(),
                                    inertial.moments().stream().map(m -> factor * m).toList())),
                    link.mesh()))
        .toList();
  }

  private Vector3 gravity(Element mujoco) {
    Vector3 gravity = new Vector3(0, 0, -9.81);
    for (Element option : mujoco.children("option")) {
      gravity = numbers.vector(option, "gravity", gravity);
      for (Element flag : option.children("flag")) {
        if (flag.attribute("gravity").filter("disable"::equals).isPresent()) {
          gravity = Vector3.ZERO;
        }
      }
    }
    return gravity;
  }

  private void noteSettings(Element mujoco) {
    for (Element option : mujoco.children("option")) {
      for (String name : List.of("density", "viscosity", "wind")) {
        option
            .attribute(name)
            .filter(value -> !value.matches("[\\s+\\-0.]*"))
            .ifPresent(value -> losses.add(option, name + " of the medium is left out"));
      }
    }
    for (Element compiler : mujoco.children("compiler")) {
      for (String name : List.of("balanceinertia", "boundmass", "boundinertia")) {
        compiler
            .attribute(name)
            .filter(value -> !value.equals("false") && !value.matches("-1|0+(\\.0*)?"))
            .ifPresent(value -> losses.add(compiler, name + " changes masses and is left out"));
      }
      compiler
          .attribute("coordinate")
          .filter("global"::equals)
          .ifPresent(
              value ->
                  diagnostics.error(
                      MessageCode.NOT_A_ROBOT,
                      compiler.position(),
                      "global coordinates are of MuJoCo before 2.3.4; save the model from MuJoCo"));
    }
  }

  /** Keeps the equations between joints; other equations are lost. */
  private void readEqualities(Element mujoco) {
    for (Element section : mujoco.children("equality")) {
      for (Element equality : section.children()) {
        Optional<String> follower = equality.attribute("joint1");
        if (equality.name().equals("joint") && follower.isPresent()) {
          followers.put(follower.get(), equality);
        } else {
          losses.add(equality, "is left out; close the loop in MechML, with Constraints");
        }
      }
    }
  }

  /** Returns a joint with the equation that binds it to another: q1 = c0 + c1 q2. */
  private Joint following(Joint joint) {
    Element equality = followers.get(joint.name());
    if (equality == null || !joint.type().isSingle()) {
      return joint;
    }
    List<Double> c =
        numbers.read(
            equality, "polycoef", equality.attribute("polycoef").orElse("0 1 0 0 0"), 1, 5);
    if (c.stream().skip(2).anyMatch(x -> x != 0)) {
      losses.add(equality, "a polynomial of degree 2 or more between joints is left out");
      return joint;
    }
    Optional<String> other = equality.attribute("joint2");
    if (other.isEmpty()) {
      losses.add(equality, "a joint held at a position is left out; use a jointVal with driven");
      return joint;
    }
    Coordinate own = joint.coordinate();
    // MuJoCo's polynomial is of deviations from the references, as coordinates are here.
    Mimic mimic = new Mimic(equality, other.get(), c.size() > 1 ? c.get(1) : 0, c.get(0));
    return new Joint(
        joint.element(),
        joint.name(),
        joint.type(),
        joint.parent(),
        joint.child(),
        joint.place(),
        new Coordinate(
            own.limits(),
            own.stiffness(),
            own.freePosition(),
            own.damping(),
            own.friction(),
            Optional.of(mimic)));
  }

  /** The bodies of one file. */
  private final class Bodies {
    private final MjcfDefaults defaults;
    private final MjcfCompiler compiler;
    private final MjcfJointReader jointReader;

    Bodies(Element mujoco) {
      defaults = new MjcfDefaults(mujoco);
      compiler = new MjcfCompiler(mujoco, numbers);
      jointReader = new MjcfJointReader(compiler, numbers, diagnostics, losses);
    }

    void readWorld(Element world) {
      readInside(world, WORLD, Frame.SAME, childClass(world, Optional.empty()));
    }

    /** Reads the bodies in a body or in a frame of it. */
    private void readInside(
        Element around, String parent, Frame outer, Optional<String> childClass) {
      for (Element part : around.children()) {
        switch (part.name()) {
          case "body" -> readBody(part, parent, outer, childClass);
          case "frame" ->
              readInside(
                  part,
                  parent,
                  outer.times(compiler.frame(part, part::attribute)),
                  childClass(part, childClass));
          default -> {
            if (!OF_BODY.contains(part.name())) {
              losses.add(part, "has no meaning in MechML and is left out");
            }
          }
        }
      }
    }

    private Optional<String> childClass(Element element, Optional<String> outer) {
      Optional<String> own = element.attribute("childclass");
      own.filter(name -> !defaults.has(name))
          .ifPresent(
              name ->
                  diagnostics.error(
                      MessageCode.UNKNOWN_NAME,
                      element.position(),
                      Phrase.of(
                          "%s: default class %s does not exist",
                          element.label(), Quoted.of(name))));
      return own.or(() -> outer);
    }

    private Function<String, Optional<String>> attributes(
        Element element, Optional<String> childClass) {
      return name -> defaults.attribute(element, name, childClass);
    }

    private void readBody(Element body, String parent, Frame outer, Optional<String> inherited) {
      Optional<String> childClass = childClass(body, inherited);
      String name = free(body.attribute("name").orElse("body" + links.size()), linkNames, body);
      Frame frame = outer.times(compiler.frame(body, body::attribute));
      if (body.attribute("mocap").filter("true"::equals).isPresent()) {
        losses.add(body, "it is moved from outside (mocap); in MechML it rests");
      }
      if (body.attribute("gravcomp").filter(g -> !g.matches("0*(\\.0*)?")).isPresent()) {
        losses.add(body, "gravcomp is left out: in MechML gravity acts on every body");
      }
      List<Held> held = new ArrayList<>();
      MjcfShapes shapes = new MjcfShapes(compiler, numbers, losses);
      collect(body, Frame.SAME, childClass, held, shapes);
      connect(body, name, parent, frame, held);
      Optional<Element> given = body.child("inertial");
      Optional<Inertial> inertial =
          compiler.takesInertiaOfShapes(given.isPresent())
              ? shapes.inertial(body)
              : given.flatMap(this::inertial);
      links.add(new Link(body, name, inertial, Optional.empty()));
      readInside(body, name, Frame.SAME, childClass);
    }

    /** Collects the joints and shapes of a body, also those in frames. */
    private void collect(
        Element around,
        Frame frame,
        Optional<String> childClass,
        List<Held> held,
        MjcfShapes shapes) {
      for (Element part : around.children()) {
        Function<String, Optional<String>> attribute = attributes(part, childClass);
        switch (part.name()) {
          case "joint", "freejoint" -> held.add(new Held(part, frame, attribute));
          case "geom" -> {
            shape = shape.or(() -> Optional.of(part));
            shapes.add(part, frame, attribute);
          }
          case "frame" ->
              collect(
                  part,
                  frame.times(compiler.frame(part, part::attribute)),
                  childClass(part, childClass),
                  held,
                  shapes);
          default -> {
            // Bodies are read after their parent; sites and cameras do not move anything.
          }
        }
      }
    }

    private void connect(Element body, String name, String parent, Frame frame, List<Held> held) {
      if (held.isEmpty()) {
        joints.add(
            new Joint(
                body,
                free(name + "_rest", jointNames, body),
                Freedom.FIXED,
                parent,
                name,
                Place.at(frame, AXIS),
                Coordinate.FREE));
      }
      String above = parent;
      Frame step = frame;
      for (int i = 0; i < held.size(); i++) {
        boolean last = i == held.size() - 1;
        String below = last ? name : free(name + "_" + (i + 1), linkNames, body);
        if (!last) {
          links.add(new Link(body, below, Optional.empty(), Optional.empty()));
        }
        joints.add(
            jointReader.read(held.get(i), jointName(held.get(i), name, i), above, below, step));
        above = below;
        step = Frame.SAME;
      }
    }

    private String jointName(Held held, String body, int number) {
      Element element = held.element();
      String unnamed = body + "_joint" + (number == 0 ? "" : number);
      return free(element.attribute("name").orElse(unnamed), jointNames, element);
    }

    private Optional<Inertial> inertial(Element inertial) {
      if (inertial.attribute("mass").isEmpty()) {
        numbers.missing(inertial, "attribute mass");
        return Optional.empty();
      }
      Optional<String> diagonal = inertial.attribute("diaginertia");
      Optional<String> full = inertial.attribute("fullinertia");
      List<Double> moments = new ArrayList<>();
      if (full.isPresent()) {
        moments.addAll(numbers.read(inertial, "fullinertia", full.get(), 6, 6));
      } else if (diagonal.isPresent()) {
        moments.addAll(numbers.read(inertial, "diaginertia", diagonal.get(), 3, 3));
        moments.addAll(List.of(0.0, 0.0, 0.0));
      } else {
        numbers.missing(inertial, "attribute diaginertia or fullinertia");
        return Optional.empty();
      }
      return Optional.of(
          new Inertial(
              inertial,
              compiler.frame(inertial, inertial::attribute),
              numbers.required(inertial, "mass"),
              moments));
    }

    private String free(String wished, Set<String> taken, Element element) {
      if (!taken.add(wished)) {
        diagnostics.error(
            MessageCode.DUPLICATE_NAME,
            element.position(),
            Phrase.of("another %s has the name %s", element.name(), Quoted.of(wished)));
      }
      return wished;
    }
  }
}
