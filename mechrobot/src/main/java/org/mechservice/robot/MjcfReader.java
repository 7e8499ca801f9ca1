package org.mechservice.robot;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.robot.MjcfCompiler.InertiaSource;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.PoseSpring;
import org.mechservice.robot.Robot.Start;
import org.mechservice.robot.Robot.Visual;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads a model of MuJoCo: nested bodies, each with the joints to the body around it. Several
 * joints of one body become links without mass between them. Positions count from the pose that the
 * file gives, as MuJoCo's do where {@code ref} is zero. Replicas and attached models are read as
 * often as they stand there; equations, tendons and motors are those of {@link MjcfForces}.
 *
 * <p>Source: MuJoCo documentation, XML reference.
 */
final class MjcfReader {
  static final String WORLD = "world";

  private static final Vector3 AXIS = new Vector3(0, 0, 1);

  /** Part of a sum of moments that the digits of a file may be off. */
  private static final double ROUNDING = 1e-9;

  /** Models attached within each other; more are a circle. */
  private static final int MOST_ATTACHED = 20;

  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotFiles files;
  private final boolean seen;
  private final RobotNumbers numbers;
  private final List<Link> links = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();
  private final List<Force> forces = new ArrayList<>();
  private final Set<String> linkNames = new HashSet<>();
  private final Set<String> jointNames = new HashSet<>();
  private final Set<String> given = new HashSet<>();
  private final Map<String, Frame> inWorld = new HashMap<>();
  private final Map<String, MjcfForces.Site> sites = new HashMap<>();
  private final Map<String, MjcfForces.Geom> geoms = new HashMap<>();
  private final Map<String, Double> references = new HashMap<>();
  private final Map<String, Double> weightless = new LinkedHashMap<>();

  /** Time constants and damping ratios from which MuJoCo makes springs, by joint. */
  private final Map<String, List<Double>> springDampers = new LinkedHashMap<>();

  /** Shapes that feel the medium by themselves, one for each link that has any. */
  private final Map<String, Element> ellipsoids = new HashMap<>();

  private final List<Scope> scopes = new ArrayList<>();
  private final Set<String> uses = new HashSet<>();
  private Optional<Element> touching = Optional.empty();
  private MjcfOptions options = MjcfOptions.NONE;
  private int attached;
  private long replicas;

  /**
   * One use of a model: the file itself, an attached one, or a replica.
   *
   * @param prefix before the names of this use
   * @param suffix behind them
   */
  record Scope(
      MjcfFile file,
      MjcfCompiler compiler,
      MjcfGeometry geometry,
      MjcfJointReader joints,
      String prefix,
      String suffix) {
    /** Returns a name of the file in this use. */
    String named(String name) {
      return name.equals(WORLD) ? WORLD : prefix + name + suffix;
    }

    Scope with(String before, String behind) {
      return new Scope(file, compiler, geometry, joints, before, behind);
    }
  }

  /**
   * @param seen whether anybody will look at the bodies
   * @param diagnostics receives errors and warnings
   * @param losses receives the parts that are not in the model
   */
  MjcfReader(RobotFiles files, boolean seen, Diagnostics diagnostics, ImportLosses losses) {
    this.files = files;
    this.seen = seen;
    this.diagnostics = diagnostics;
    this.losses = losses;
    numbers = new RobotNumbers(diagnostics);
  }

  /**
   * Returns the robot without the elements in error.
   *
   * @param keyframe name or number of the keyframe at which it starts
   */
  Robot read(Element mujoco, Optional<String> keyframe) {
    MjcfFile file =
        MjcfFile.of(mujoco, files, files.folder().orElse(Path.of("")), diagnostics, losses);
    Element root = file.root();
    options = MjcfOptions.of(root, numbers);
    Scope scope = scope(file, "", "");
    refuseGlobal(root);
    FormatTable.of(RobotFormat.MJCF).reportLosses(root, losses);
    collectNames(root);
    List<Element> worlds = root.children("worldbody");
    List<MjcfGeometry.Held> ground = new ArrayList<>();
    worlds.forEach(world -> collect(scope, world, WORLD, Frame.SAME, new ArrayList<>(), ground));
    links.add(new Link(root, WORLD, Optional.empty(), looks(scope, ground)));
    linkNames.add(WORLD);
    inWorld.put(WORLD, Frame.SAME);
    if (worlds.isEmpty()) {
      numbers.missing(root, "worldbody");
    }
    worlds.forEach(world -> readInside(scope, world, WORLD, Frame.SAME));
    touching.ifPresent(
        geometry ->
            losses.contact(geometry, "contacts between shapes are left out, here and elsewhere"));
    return together(root, scope.compiler(), keyframe);
  }

  private Robot together(Element root, MjcfCompiler compiler, Optional<String> keyframe) {
    List<Link> whole = massive(compiler);
    for (Link link : whole) {
      double factor = weightless.getOrDefault(link.name(), 0.0);
      link.inertial()
          .filter(inertial -> factor != 0 && !options.gravity().equals(Vector3.ZERO))
          .ifPresent(
              inertial ->
                  forces.add(
                      BodyForce.constant(
                          link.element(),
                          link.name() + " gravcomp",
                          link.name(),
                          inertial.frame().at(),
                          options.gravity().times(-factor * inertial.mass()))));
    }
    addMedium(whole);
    MjcfArmatures armatures = new MjcfArmatures(scopes, numbers, losses);
    joints.replaceAll(armatures::armed);
    reportMotorsAgainstWeight();
    RobotInertia inertia = new RobotInertia(whole, joints);
    springDampers.forEach((joint, values) -> makeSpring(joint, values, inertia));
    turnBack();
    MjcfForces more =
        new MjcfForces(
            joints,
            inWorld,
            sites,
            geoms,
            references,
            inertia,
            armatures,
            options,
            numbers,
            diagnostics,
            losses);
    scopes.forEach(more::read);
    forces.addAll(more.forces());
    joints.replaceAll(more::withoutIdleLimits);
    boolean alignsFree = compiler.setting("alignfree").filter("true"::equals).isPresent();
    MjcfKeyframe start =
        new MjcfKeyframe(joints, references, alignsFree, numbers, diagnostics, losses);
    Map<String, Start> starts = start.read(root, keyframe);
    List<Link> all = new ArrayList<>(whole);
    more.rotors()
        .forEach(rotor -> all.add(new Link(rotor.element(), rotor.child(), Optional.empty())));
    joints.addAll(more.rotors());
    return new Robot(
        RobotFormat.MJCF,
        root.attribute("model").orElse("robot"),
        Optional.of(options.gravity()),
        all,
        joints,
        more.loops(),
        more.couplings(),
        forces,
        starts);
  }

  private void addMedium(List<Link> whole) {
    MjcfMedium medium = new MjcfMedium(options, losses);
    for (Link link : whole) {
      Element ellipsoid = ellipsoids.get(link.name());
      List<Force> around = medium.around(link);
      if (ellipsoid == null) {
        forces.addAll(around);
      } else if (!around.isEmpty()) {
        losses.motion(ellipsoid, "the medium around an ellipsoid is left out");
      }
    }
  }

  private void reportMotorsAgainstWeight() {
    if (!weightless.isEmpty()) {
      joints.stream()
          .map(Joint::element)
          .filter(one -> one.attribute("actuatorgravcomp").filter("true"::equals).isPresent())
          .forEach(
              one ->
                  losses.motion(
                      one, "actuatorgravcomp is left out: gravcomp acts without motors, too"));
    }
  }

  /** MuJoCo takes the inertia that the joint moves in the pose of the file, all others free. */
  private void makeSpring(String name, List<Double> values, RobotInertia inertia) {
    double time = values.get(0);
    double ratio = values.get(1);
    if (!(time > 0) || !(ratio > 0)) {
      return;
    }
    for (int i = 0; i < joints.size(); i++) {
      Joint joint = joints.get(i);
      if (joint.name().equals(name)) {
        double held = inertia.free(name);
        double stiffness = options.springs() ? held / (time * time * ratio * ratio) : 0;
        double damping = options.dampers() ? 2 * held / time : 0;
        joints.set(i, joint.with(joint.coordinate().with(stiffness, damping)));
      }
    }
  }

  /** Makes springs between two links of those of balls and free joints. */
  private void turnBack() {
    for (int i = 0; i < joints.size(); i++) {
      Joint joint = joints.get(i);
      double stiffness = joint.coordinate().stiffness();
      if (joint.type().turnsFreely() && stiffness != 0) {
        forces.add(
            new PoseSpring(
                joint.element(),
                joint.name() + " spring",
                joint.parent(),
                joint.child(),
                joint.place().frame(),
                joint.place().point(),
                joint.type() == Freedom.FLOATING ? stiffness : 0,
                stiffness));
        joints.set(i, joint.with(joint.coordinate().with(0, joint.coordinate().damping())));
      }
    }
  }

  private void refuseGlobal(Element mujoco) {
    for (Element compiler : mujoco.children("compiler")) {
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

  /** Notes the names of the file, so that none that the import makes meets them. */
  private void collectNames(Element element) {
    if (Set.of("body", "joint", "freejoint").contains(element.name())) {
      element.attribute("name").ifPresent(given::add);
    }
    element.children().forEach(this::collectNames);
  }

  private Scope scope(MjcfFile file, String prefix, String suffix) {
    MjcfCompiler compiler = new MjcfCompiler(file.root(), numbers);
    new MjcfRules(numbers).checkComplete(file.root(), compiler.autolimits());
    Scope scope =
        new Scope(
            file,
            compiler,
            new MjcfGeometry(file, compiler, files, numbers, diagnostics, losses),
            new MjcfJointReader(compiler, options, numbers, diagnostics, losses),
            prefix,
            suffix);
    scopes.add(scope);
    return scope;
  }

  /** Returns the links with the masses that the compiler's settings ask for. */
  private List<Link> massive(MjcfCompiler compiler) {
    double total =
        links.stream().flatMap(link -> link.inertial().stream()).mapToDouble(Inertial::mass).sum();
    double wished = compiler.number("settotalmass", -1);
    return wished > 0 && total > 0
        ? links.stream()
            .map(link -> link.with(link.inertial().map(one -> one.times(wished / total))))
            .toList()
        : List.copyOf(links);
  }

  /** Reads the bodies in a body, or in a frame of it. */
  private void readInside(Scope scope, Element around, String parent, Frame outer) {
    for (Element part : around.children()) {
      switch (part.name()) {
        case "body" -> readBody(scope, part, parent, outer);
        case "frame" -> readInside(scope, part, parent, outer.times(scope.compiler().frame(part)));
        case "replicate" ->
            replicas(scope, part)
                .forEach((replica, frame) -> readInside(replica, part, parent, outer.times(frame)));
        case "attach" -> attach(scope, part, parent, outer);
        case "site" -> addSite(scope, part, parent, outer);
        default -> {
          // Joints and shapes belong to the body itself.
        }
      }
    }
  }

  private void addSite(Scope scope, Element site, String parent, Frame outer) {
    site.attribute("name")
        .ifPresent(
            name ->
                sites.put(
                    scope.named(name),
                    new MjcfForces.Site(parent, outer.times(scope.compiler().frame(site)))));
  }

  /** Returns each replica with its frame: each is moved from the one before it in its axes. */
  private Map<Scope, Frame> replicas(Scope scope, Element replicate) {
    double wished = numbers.required(replicate, "count");
    int count = (int) wished;
    if (count < 1 || count != wished) {
      numbers.contradiction(replicate, "count is " + wished + "; write a whole number from 1 on");
      return Map.of();
    }
    replicas += count;
    if (replicas > Limits.BODIES) {
      diagnostics.error(
          MessageCode.MODEL_FILE_TOO_LARGE,
          replicate.position(),
          "there are more than " + Limits.BODIES + " replicas");
      return Map.of();
    }
    Vector3 offset = numbers.vector(replicate, "offset", Vector3.ZERO);
    String separator = replicate.attribute("sep").orElse("");
    int digits = String.valueOf(count).length();
    Map<Scope, Frame> all = new LinkedHashMap<>();
    Vector3 at = Vector3.ZERO;
    for (int i = 0; i < count; i++) {
      Frame frame = new Frame(at, scope.compiler().turnOfReplica(replicate, i));
      String number = "0".repeat(digits - String.valueOf(i).length()) + i;
      Scope replica = scope.with(scope.prefix(), separator + number + scope.suffix());
      // Several replicates of a file share their suffixes, and what refers to them is read once.
      if (uses.add(replica.prefix() + '\0' + replica.suffix())) {
        scopes.add(replica);
      }
      all.put(replica, frame);
      at = at.plus(frame.turn().apply(offset));
    }
    return all;
  }

  private void attach(Scope scope, Element attach, String parent, Frame outer) {
    Optional<MjcfFile> attachable =
        attach.attribute("model").isPresent()
            ? model(scope, attach)
            : Optional.of(scope.file()); // a part of the file itself
    if (attachable.isEmpty()) {
      return;
    }
    MjcfFile model = attachable.get();
    Scope inner =
        scope(model, scope.prefix() + attach.attribute("prefix").orElse(""), scope.suffix());
    if (attached == MOST_ATTACHED) {
      numbers.contradiction(
          attach, "models are attached in each other more than " + MOST_ATTACHED + " deep");
      return;
    }
    attached++;
    attachPart(inner, attach, parent, outer);
    attached--;
  }

  /**
   * Returns the model that is asked for; empty, with a message, if there is none. One without a
   * name among the assets has that of its own file.
   */
  private Optional<MjcfFile> model(Scope scope, Element attach) {
    String wished = attach.attribute("model").orElse("");
    Path around = scope.file().folder();
    Set<String> known = new HashSet<>();
    for (Element asset : scope.file().all("asset")) {
      if (!asset.name().equals("model")) {
        continue;
      }
      String fileName = asset.attribute("file").orElse("");
      Optional<String> given = asset.attribute("name");
      if (given.isPresent() && !given.get().equals(wished)) {
        known.add(given.get());
        continue;
      }
      Optional<Element> root = files.read(asset, fileName, around, diagnostics);
      if (root.isEmpty()) {
        return Optional.empty();
      }
      String own = given.or(() -> root.get().attribute("model")).orElse("");
      if (own.equals(wished) || fileName.equals(wished)) {
        Path folder =
            files
                .find(fileName, around)
                .flatMap(found -> Optional.ofNullable(found.getParent()))
                .orElse(around);
        MjcfFile model = MjcfFile.of(root.get(), files, folder, diagnostics, losses);
        FormatTable.of(RobotFormat.MJCF).reportLosses(model.root(), losses);
        return Optional.of(model);
      }
      known.add(own);
    }
    unknown(attach, "model", wished, known);
    return Optional.empty();
  }

  /** Attaches the body or frame that is asked for, or the whole world of the model. */
  private void attachPart(Scope inner, Element attach, String parent, Frame outer) {
    Element model = inner.file().root();
    Optional<String> wished = attach.attribute("body").or(() -> attach.attribute("frame"));
    String kind = attach.attribute("frame").isPresent() ? "frame" : "body";
    if (wished.isEmpty()) {
      model.children("worldbody").forEach(w -> readInside(inner, w, parent, outer));
      return;
    }
    Optional<Element> found =
        model.children("worldbody").stream()
            .flatMap(world -> find(world, kind, wished.get()).stream())
            .findFirst();
    if (found.isEmpty()) {
      unknown(attach, kind, wished.get(), Set.of());
    } else if (kind.equals("body")) {
      readBody(inner, found.get(), parent, outer);
    } else {
      readInside(inner, found.get(), parent, outer.times(inner.compiler().frame(found.get())));
    }
  }

  private static Optional<Element> find(Element around, String kind, String name) {
    for (Element part : around.children()) {
      if (part.name().equals(kind) && part.attribute("name").filter(name::equals).isPresent()) {
        return Optional.of(part);
      }
      Optional<Element> inside = find(part, kind, name);
      if (inside.isPresent()) {
        return inside;
      }
    }
    return Optional.empty();
  }

  private void unknown(Element asking, String kind, String name, Set<String> known) {
    diagnostics.error(
        MessageCode.UNKNOWN_NAME,
        asking.position(),
        Phrase.of(
            "%s: %s %s does not exist%s",
            asking.label(), kind, Quoted.of(name), NearestName.suggestion(name, known)));
  }

  /** A joint of a body: its element and the frame in the body that its place is in. */
  private record HeldJoint(Scope scope, Element element, Frame frame) {}

  private void readBody(Scope scope, Element body, String parent, Frame outer) {
    String name =
        body.attribute("name")
            .map(own -> named(scope.named(own), linkNames, body))
            .orElseGet(() -> made("body" + links.size(), linkNames));
    Frame frame = outer.times(scope.compiler().frame(body));
    inWorld.put(name, inWorld.getOrDefault(parent, Frame.SAME).times(frame));
    if (body.attribute("mocap").filter("true"::equals).isPresent()) {
      losses.contact(body, "it is moved from outside (mocap); in the model it rests");
    }
    double factor = numbers.optional(body, "gravcomp", 0);
    if (factor != 0) {
      weightless.put(name, factor);
    }
    List<HeldJoint> held = new ArrayList<>();
    List<MjcfGeometry.Held> shapes = new ArrayList<>();
    collect(scope, body, name, Frame.SAME, held, shapes);
    if (body.attribute("mocap").filter("true"::equals).isPresent()
        && !(held.isEmpty() && parent.equals(WORLD))) {
      numbers.contradiction(
          body, "it is moved from outside (mocap), and rests on the world without a joint");
    }
    shapes.stream()
        .map(MjcfGeometry.Held::element)
        .filter(one -> one.attribute("fluidshape").filter("ellipsoid"::equals).isPresent())
        .findFirst()
        .ifPresent(one -> ellipsoids.put(name, one));
    connect(scope, body, name, parent, frame, held);
    links.add(new Link(body, name, inertia(scope, body, shapes), looks(scope, shapes)));
    readInside(scope, body, name, Frame.SAME);
  }

  private List<Visual> looks(Scope scope, List<MjcfGeometry.Held> shapes) {
    return seen ? scope.geometry().visuals(shapes) : List.of();
  }

  private Optional<Inertial> inertia(Scope scope, Element body, List<MjcfGeometry.Held> shapes) {
    MjcfCompiler compiler = scope.compiler();
    List<Element> given = body.children("inertial");
    if (given.size() > 1) {
      numbers.contradiction(given.get(1), "it is the second of its body; leave one out");
    }
    InertiaSource source = compiler.inertiaSource();
    boolean ofShapes =
        source == InertiaSource.SHAPES || (source == InertiaSource.AUTO && given.isEmpty());
    Optional<Inertial> own = given.stream().findFirst().flatMap(one -> inertial(compiler, one));
    // a body whose shapes have no say keeps what it is given
    return bounded(
        compiler, body, ofShapes ? scope.geometry().inertial(body, shapes).or(() -> own) : own);
  }

  private Optional<Inertial> bounded(MjcfCompiler compiler, Element body, Optional<Inertial> read) {
    double least = compiler.number("boundmass", 0);
    double leastMoment = compiler.number("boundinertia", 0);
    boolean balances = compiler.setting("balanceinertia").filter("true"::equals).isPresent();
    if (least <= 0 && leastMoment <= 0 && !balances) {
      read.ifPresent(
          one -> requirePossible(one.element(), PrincipalAxes.of(one.moments()).moments()));
      return read;
    }
    Inertial inertial =
        read.orElseGet(
            () -> // a body without mass gets its own there as far from itself as from its parent
            new Inertial(body, compiler.frame(body), 0, List.of(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)));
    PrincipalAxes axes = PrincipalAxes.of(inertial.moments());
    double[] moments = axes.moments();
    Arrays.setAll(moments, k -> Math.max(moments[k], leastMoment));
    double sum = moments[0] + moments[1] + moments[2];
    if (balances && Arrays.stream(moments).anyMatch(m -> 2 * m > sum)) {
      Arrays.fill(moments, sum / 3);
    }
    requirePossible(inertial.element(), moments);
    return Optional.of(
        new Inertial(
            inertial.element(),
            inertial.frame().times(new Frame(Vector3.ZERO, axes.frame())),
            Math.max(inertial.mass(), Math.max(least, 0)),
            List.of(moments[0], moments[1], moments[2], 0.0, 0.0, 0.0)));
  }

  /** MuJoCo refuses moments that no body has; of meshes and fits rounding may be beyond. */
  private void requirePossible(Element inertial, double[] moments) {
    double sum = moments[0] + moments[1] + moments[2];
    double most = Arrays.stream(moments).max().orElse(0);
    if (inertial.name().equals("inertial") && 2 * most > sum * (1 + ROUNDING)) {
      numbers.contradiction(
          inertial,
          "its largest principal moment, "
              + most
              + " kg*m^2, is more than the sum of the others; MuJoCo then needs"
              + " balanceinertia=\"true\" of the compiler");
    }
  }

  /** Collects the joints and shapes of a body, also those in frames and replicas. */
  private void collect(
      Scope scope,
      Element around,
      String link,
      Frame frame,
      List<HeldJoint> held,
      List<MjcfGeometry.Held> shapes) {
    for (Element part : around.children()) {
      switch (part.name()) {
        case "joint", "freejoint" -> held.add(new HeldJoint(scope, part, frame));
        case "geom" -> {
          if (touches(part)) {
            touching = touching.or(() -> Optional.of(part));
          }
          shapes.add(new MjcfGeometry.Held(part, frame));
          part.attribute("name")
              .ifPresent(
                  own ->
                      geoms.put(
                          scope.named(own),
                          new MjcfForces.Geom(
                              part, link, frame.times(scope.geometry().placed(part)))));
        }
        case "frame" ->
            collect(scope, part, link, frame.times(scope.compiler().frame(part)), held, shapes);
        case "replicate" -> {
          if (part.child("geom").isPresent() || part.child("frame").isPresent()) {
            replicas(scope, part)
                .forEach(
                    (replica, place) ->
                        collect(replica, part, link, frame.times(place), held, shapes));
          }
        }
        default -> {
          // Bodies are read after their parent; cameras do not move anything.
        }
      }
    }
  }

  private static boolean touches(Element geometry) {
    return !geometry.attribute("contype").orElse("1").strip().equals("0")
        || !geometry.attribute("conaffinity").orElse("1").strip().equals("0");
  }

  private void connect(
      Scope scope, Element body, String name, String parent, Frame frame, List<HeldJoint> held) {
    if (held.isEmpty()) {
      joints.add(
          new Joint(
              body,
              made(name + "_rest", jointNames),
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
      HeldJoint one = held.get(i);
      String below = last ? name : made(name + "_" + (i + 1), linkNames);
      if (!last) {
        links.add(new Link(body, below, Optional.empty()));
      }
      String unnamed = name + "_joint" + (i == 0 ? "" : i);
      String jointName =
          one.element()
              .attribute("name")
              .map(own -> named(scope.named(own), jointNames, one.element()))
              .orElseGet(() -> made(unnamed, jointNames));
      addJoint(one, jointName, above, below, step);
      above = below;
      step = Frame.SAME;
    }
  }

  private void addJoint(HeldJoint held, String name, String above, String below, Frame step) {
    Element element = held.element();
    Joint joint = held.scope().joints().read(element, held.frame(), name, above, below, step);
    references.put(name, held.scope().joints().reference(element, joint.type()));
    element
        .attribute("springdamper")
        .map(text -> numbers.read(element, "springdamper", text, 2, 2))
        .ifPresent(values -> springDampers.put(name, values));
    joints.add(joint);
  }

  private Optional<Inertial> inertial(MjcfCompiler compiler, Element inertial) {
    if (inertial.attribute("mass").isEmpty()) {
      numbers.missing(inertial, "attribute mass");
      return Optional.empty();
    }
    if (inertial.attribute("pos").isEmpty()) {
      numbers.missing(inertial, "attribute pos");
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
      moments.addAll(Collections.nCopies(6, 0.0));
      if (!(compiler.number("boundinertia", 0) > 0)) {
        numbers.missing(inertial, "attribute diaginertia or fullinertia");
      }
    }
    return Optional.of(
        new Inertial(
            inertial, compiler.frame(inertial), numbers.required(inertial, "mass"), moments));
  }

  /** Returns a name of the file; a second one of its kind is an error. */
  private String named(String wished, Set<String> taken, Element element) {
    if (!taken.add(wished)) {
      diagnostics.error(
          MessageCode.DUPLICATE_NAME,
          element.position(),
          Phrase.of("another %s has the name %s", element.name(), Quoted.of(wished)));
    }
    return wished;
  }

  /** Returns a name that the import makes: none of the file and none that is taken. */
  private String made(String wished, Set<String> taken) {
    String free = wished;
    while (given.contains(free) || !taken.add(free)) {
      free += "_";
    }
    return free;
  }
}
