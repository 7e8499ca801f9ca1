package org.mechservice.robot;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Coupling;
import org.mechservice.robot.Robot.FileShape;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.robot.Robot.OwnShape;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.Shape;
import org.mechservice.robot.Robot.Start;
import org.mechservice.robot.Robot.Visual;
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
  private static final double WATER = 1000;

  /** Least cosine between axes that count as one: files write angles with some seven digits. */
  private static final double PARALLEL = 1 - 1e-9;

  /** SDF's gravity of a world that gives none, m/s². */
  private static final Vector3 WORLD_GRAVITY = new Vector3(0, 0, -9.8);

  /** What the import takes for a model without a world, m/s². */
  private static final Vector3 GRAVITY = new Vector3(0, 0, -9.81);

  /** SDF's value of what a file leaves out: a link without inertial has a mass of 1 kg. */
  private static final List<Double> UNIT_MOMENTS = List.of(1.0, 1.0, 1.0, 0.0, 0.0, 0.0);

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotNumbers numbers;
  private final SdfFrames frames;
  private final List<Link> links = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();
  private final Set<String> fixed = new HashSet<>();
  private final List<Force> forces = new ArrayList<>();
  private final List<Coupling> couplings = new ArrayList<>();

  /** Reads the gears, once all joints are known. */
  private final List<Runnable> gears = new ArrayList<>();

  private final Map<String, Start> starts = new HashMap<>();
  private final RobotFiles files;
  private Vector3 gravity = GRAVITY;
  private boolean axesOfModel;

  /**
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that MechML cannot express
   */
  SdfReader(RobotFiles files, Diagnostics diagnostics, ImportLosses losses) {
    this.files = files;
    this.diagnostics = diagnostics;
    this.losses = losses;
    numbers = new RobotNumbers(diagnostics);
    frames = new SdfFrames(diagnostics, numbers);
  }

  /** Returns the robot without the elements in error. */
  Robot read(Element file) {
    FormatTable table = FormatTable.of(RobotFormat.SDF);
    table.checkNames(file, diagnostics, losses);
    Element sdf = new SdfIncludes(files, diagnostics).put(file, files.folder().orElse(Path.of("")));
    table.reportLosses(sdf, losses);
    axesOfModel = sdf.attribute("version").filter(v -> v.matches("1\\.[0-4]")).isPresent();
    List<Element> worlds = sdf.children("world");
    worlds.stream()
        .skip(1)
        .forEach(more -> losses.motion(more, "it is left out: the first world is read"));
    Optional<Element> world = worlds.stream().findFirst();
    Element scene = world.orElse(sdf);
    if (world.isPresent()) {
      gravity =
          world.get().child("gravity").map(g -> vector(numbers.text(g, 3))).orElse(WORLD_GRAVITY);
      sdf.children("model")
          .forEach(more -> losses.motion(more, "it is left out: it stands beside a world"));
    }
    List<Element> models = scene.children("model");
    if (models.isEmpty()) {
      numbers.missing(scene, "models");
    }
    links.add(new Link(sdf, SdfFrames.WORLD, Optional.empty()));
    boolean several =
        models.size() > 1 || scene.child("joint").isPresent() || scene.child("frame").isPresent();
    for (Element model : models) {
      String name = model.attribute("name").orElse("model");
      frames.addModel(several ? name + SdfFrames.SCOPE : "", "", model);
    }
    if (world.isPresent()) {
      frames.addWorld(world.get());
    }
    for (Element model : models) {
      String name = model.attribute("name").orElse("model");
      readModel(several ? name + SdfFrames.SCOPE : "", model, false);
    }
    for (Element joint : world.map(one -> one.children("joint")).orElse(List.of())) {
      joint.attribute("name").ifPresent(name -> readJoint("", name, joint));
    }
    gears.forEach(Runnable::run);
    attachFreeLinks();
    return new Robot(
        RobotFormat.SDF,
        models.stream().findFirst().flatMap(m -> m.attribute("name")).orElse("robot"),
        world.isPresent() ? Optional.of(gravity) : Optional.empty(),
        links,
        joints,
        List.of(),
        couplings,
        forces,
        starts);
  }

  private static Vector3 vector(List<Double> xyz) {
    return new Vector3(xyz.get(0), xyz.get(1), xyz.get(2));
  }

  private void readModel(String scope, Element model, boolean inStatic) {
    boolean rests = inStatic || isTrue(model.child("static"));
    numbers.requireOnce(model, List.of("pose", "static"));
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
    numbers.requireOnce(link, List.of("inertial", "pose", "gravity"));
    link.child("collision")
        .ifPresent(collision -> losses.contact(collision, "collision shapes are left out"));
    Inertial inertial = inertial(link);
    links.add(new Link(link, name, Optional.of(inertial), visuals(link)));
    if (rests) {
      fixed.add(name);
    } else if (link.child("gravity").isPresent() && !isTrue(link.child("gravity"))) {
      forces.add(
          BodyForce.constant(
              link,
              name + " without gravity",
              name,
              inertial.frame().at(),
              gravity.times(-inertial.mass())));
    }
  }

  private Inertial inertial(Element link) {
    Optional<Element> found = link.child("inertial");
    if (found.isEmpty()) {
      losses.picture(link, "it has no <inertial>: SDF then means 1 kg and 1 kg·m² about each axis");
      return new Inertial(link, Frame.SAME, 1, UNIT_MOMENTS);
    }
    Element inertial = found.get();
    numbers.requireOnce(inertial, List.of("mass", "inertia", "pose"));
    if (inertial.attribute("auto").filter(a -> a.equals("true") || a.equals("1")).isPresent()) {
      return automatic(link, inertial);
    }
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

  /** Returns what a link looks like. */
  private List<Visual> visuals(Element link) {
    List<Visual> all = new ArrayList<>();
    for (Element visual : link.children("visual")) {
      Optional<Element> one =
          visual.child("geometry").flatMap(g -> g.children().stream().findFirst());
      Optional<Shape> shape = one.flatMap(this::look);
      shape.ifPresent(
          s -> all.add(new Visual(visual, frames.pose(visual.child("pose")), s, colour(visual))));
    }
    return all;
  }

  private Optional<Shape> look(Element one) {
    double r = numbers.text(one, "radius", 0);
    double length = numbers.text(one, "length", 0);
    return switch (one.name()) {
      case "box" ->
          Optional.of(
              new OwnShape(Surfaces.box(vector(numbers.text(one.child("size").orElse(one), 3)))));
      case "sphere" -> Optional.of(new OwnShape(Surfaces.ellipsoid(new Vector3(r, r, r))));
      case "cylinder" -> Optional.of(new OwnShape(Surfaces.cylinder(r, length)));
      case "capsule" -> Optional.of(new OwnShape(Surfaces.capsule(r, length)));
      case "cone" -> Optional.of(new OwnShape(Surfaces.cone(r, length)));
      case "ellipsoid" ->
          Optional.of(
              new OwnShape(
                  Surfaces.ellipsoid(vector(numbers.text(one.child("radii").orElse(one), 3)))));
      case "mesh" -> {
        String name = one.child("uri").map(Element::text).orElse("");
        Path folder =
            one.position().included().isEmpty()
                ? files.folder().orElse(Path.of(""))
                : Objects.requireNonNullElse(
                    Path.of(one.position().included()).getParent(), Path.of(""));
        yield Optional.of(
            new FileShape(
                name,
                files.find(name, folder),
                one.child("scale")
                    .map(scale -> vector(numbers.text(scale, 3)))
                    .orElse(new Vector3(1, 1, 1))));
      }
      default -> Optional.empty();
    };
  }

  private Optional<List<Double>> colour(Element visual) {
    double clear = numbers.text(visual, "transparency", 0);
    return visual
        .child("material")
        .flatMap(material -> material.child("diffuse"))
        .map(
            diffuse -> {
              List<Double> c = numbers.read(diffuse, "its text", diffuse.text(), 3, 4);
              double opacity = (c.size() > 3 ? c.get(3) : 1) * (1 - clear);
              return List.of(c.get(0), c.get(1), c.get(2), opacity);
            });
  }

  /** Returns the inertia of the collision shapes of a link. */
  private Inertial automatic(Element link, Element inertial) {
    ShapeMasses masses = new ShapeMasses();
    double ofLink = numbers.text(inertial, "density", WATER);
    for (Element collision : link.children("collision")) {
      double density = numbers.text(collision, "density", ofLink);
      Optional<UniformShape> shape =
          collision.child("geometry").flatMap(geometry -> shape(collision, geometry));
      if (collision.child("pose").flatMap(p -> p.attribute("relative_to")).isPresent()) {
        losses.motion(collision, "its pose is taken in the link, though it names another frame");
      }
      Frame frame = frames.pose(collision.child("pose"));
      shape.ifPresent(one -> masses.add(frame, density * one.volume(), one));
    }
    Optional<Inertial> sum = masses.inertial(inertial);
    if (sum.isEmpty()) {
      numbers.contradiction(inertial, "auto asks for the inertia of collision shapes; it has none");
      return new Inertial(link, Frame.SAME, 1, UNIT_MOMENTS);
    }
    // A mass that is given holds; the shapes say how it is spread.
    double mass = numbers.text(inertial, "mass", sum.get().mass());
    return sum.get().times(mass / sum.get().mass());
  }

  private Optional<UniformShape> shape(Element collision, Element geometry) {
    for (Element one : geometry.children()) {
      double r = numbers.text(one, "radius", 0);
      double length = numbers.text(one, "length", 0);
      switch (one.name()) {
        case "box" -> {
          List<Double> e = numbers.text(one.child("size").orElse(one), 3);
          return Optional.of(UniformShape.box(e.get(0) / 2, e.get(1) / 2, e.get(2) / 2));
        }
        case "sphere" -> {
          return Optional.of(UniformShape.ellipsoid(r, r, r));
        }
        case "cylinder" -> {
          return Optional.of(UniformShape.cylinder(r, length / 2));
        }
        case "capsule" -> {
          return Optional.of(UniformShape.capsule(r, length / 2));
        }
        case "cone" -> {
          return Optional.of(UniformShape.cone(r, length));
        }
        case "ellipsoid" -> {
          List<Double> e = numbers.text(one.child("radii").orElse(one), 3);
          return Optional.of(UniformShape.ellipsoid(e.get(0), e.get(1), e.get(2)));
        }
        default -> losses.motion(collision, "its mass is left out: it is a " + one.name());
      }
    }
    return Optional.empty();
  }

  private Optional<Mimic> mimic(String scope, Element axis) {
    return axis.child("mimic")
        .flatMap(
            mimic -> {
              Optional<String> leader = mimic.attribute("joint");
              if (leader.isEmpty()) {
                numbers.missing(mimic, "attribute joint");
              }
              if (mimic.attribute("axis").filter(a -> !a.equals("axis")).isPresent()) {
                losses.motion(mimic, "it follows the first axis instead of axis2");
              }
              double factor = numbers.text(mimic, "multiplier", 0);
              double offset =
                  numbers.text(mimic, "offset", 0) - factor * numbers.text(mimic, "reference", 0);
              return leader.map(name -> new Mimic(mimic, scope + name, factor, offset));
            });
  }

  private void noteStart(String name, Element axis) {
    double position = numbers.text(axis, "initial_position", 0);
    if (position != 0) {
      starts.put(name, new Start(List.of(position), List.of(0.0)));
    }
  }

  private void readJoint(String scope, String name, Element element) {
    numbers.requireOnce(
        element,
        List.of(
            "parent", "child", "axis", "axis2", "pose", "gearbox_ratio", "gearbox_reference_body"));
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
        noteStart(scope + name, axis);
        SdfAxis read = new SdfAxis(axis, numbers);
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
                read.coordinate(type.equals("continuous"), armature(element), mimic(scope, axis))));
      }
      case "universal", "revolute2" -> {
        // Two hinges with a cross without mass between them.
        String cross = scope + name + "_cross";
        if (armature(element) != 0) {
          losses.motion(element, "the inertia of a motor is left out: it has two axes");
        }
        Element first = axis(element, "axis");
        Element second = axis(element, "axis2");
        links.add(new Link(element, cross, Optional.empty()));
        joints.add(
            new Joint(
                element,
                scope + name,
                Freedom.REVOLUTE,
                parent.get(),
                cross,
                Place.along(childInParent, jointInChild.at(), direction(scope, name, first, below)),
                new SdfAxis(first, numbers).coordinate(false, 0, mimic(scope, first))));
        joints.add(
            new Joint(
                element,
                scope + name + "_2",
                Freedom.REVOLUTE,
                cross,
                child.get(),
                Place.along(Frame.SAME, jointInChild.at(), direction(scope, name, second, below)),
                new SdfAxis(second, numbers).coordinate(false, 0, mimic(scope, second))));
      }
      case "gearbox" ->
          gears.add(() -> readGear(scope, name, element, parent.get(), child.get(), below));
      default ->
          diagnostics.error(
              MessageCode.VALUE_NOT_IN_LIST,
              element.position(),
              Phrase.of(
                  "%s: type is %s; the import knows revolute, continuous, prismatic, fixed, ball,"
                      + " universal, revolute2, screw, gearbox",
                  element.label(), Quoted.of(type)));
    }
  }

  /**
   * Reads a gear as an equation between two hinges of its reference body: the angle of the child
   * about axis2 is -ratio times that of the parent about axis. A gear leaves both bodies free.
   */
  private void readGear(
      String scope, String name, Element gear, String parent, String child, Frame below) {
    Optional<String> base = end(scope, gear, "gearbox_reference_body");
    if (base.isEmpty()) {
      return;
    }
    double ratio = numbers.text(gear, "gearbox_ratio", 1);
    Map<String, Double> terms = new LinkedHashMap<>();
    addAngle(gear, base.get(), parent, inWorld(scope, name, gear, "axis", below), ratio, terms);
    addAngle(gear, base.get(), child, inWorld(scope, name, gear, "axis2", below), 1, terms);
    if (terms.size() == 2) {
      couplings.add(new Coupling(gear, scope + name, terms, Optional.empty(), 0));
    }
  }

  private Vector3 inWorld(String scope, String name, Element gear, String axis, Frame below) {
    return below.turn().apply(direction(scope, name, axis(gear, axis), below));
  }

  /** Adds the angle of a link against the reference body of a gear, by the hinge between them. */
  private void addAngle(
      Element gear,
      String base,
      String link,
      Vector3 axis,
      double factor,
      Map<String, Double> terms) {
    for (Joint joint : joints) {
      boolean outward = joint.parent().equals(base) && joint.child().equals(link);
      boolean inward = joint.parent().equals(link) && joint.child().equals(base);
      boolean turns = joint.type() == Freedom.REVOLUTE || joint.type() == Freedom.CONTINUOUS;
      if (turns && (outward || inward)) {
        Vector3 own = frames.inWorld(joint.child()).turn().apply(joint.place().axis());
        double along = own.dot(axis);
        if (Math.abs(along) < PARALLEL) {
          numbers.contradiction(
              gear,
              Phrase.of(
                  "its axis for link %s is not that of joint %s, by which the link turns in %s",
                  Quoted.of(link), Quoted.of(joint.name()), Quoted.of(base)));
        }
        terms.merge(joint.name(), Math.signum(along) * (outward ? factor : -factor), Double::sum);
        return;
      }
    }
    numbers.contradiction(
        gear,
        Phrase.of(
            "no hinge is between link %s and its gearbox_reference_body %s",
            Quoted.of(link), Quoted.of(base)));
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

  /** Returns the inertia of a motor behind its gear, which Drake adds to SDF. */
  private double armature(Element joint) {
    double ratio = numbers.text(joint, "drake:gear_ratio", 1);
    return ratio * ratio * numbers.text(joint, "drake:rotor_inertia", 0);
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
