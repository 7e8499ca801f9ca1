package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Around;
import org.mechservice.robot.Robot.Branch;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Coupling;
import org.mechservice.robot.Robot.CouplingSpring;
import org.mechservice.robot.Robot.Eye;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Loop;
import org.mechservice.robot.Robot.PathSpring;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.PointSpring;
import org.mechservice.robot.Robot.Stop;
import org.mechservice.robot.Robot.Waypoint;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Equations and tendons of an MJCF model, and its motors with {@link MjcfActuators}. MuJoCo's
 * equations are soft; here they are exact. Source: MuJoCo documentation, XML reference, {@code
 * equality} and {@code tendon}.
 */
final class MjcfForces {
  /**
   * A place with a name.
   *
   * @param link that has it
   * @param frame in the link
   */
  record Site(String link, Frame frame) {
    Eye eye() {
      return new Eye(link, frame.at());
    }
  }

  /**
   * A shape with a name.
   *
   * @param element its element in the file
   * @param link that has it
   * @param frame in the link; the axis of a cylinder is its z axis
   */
  record Geom(Element element, String link, Frame frame) {}

  /**
   * A tendon over joints, whose length is a sum of positions, or over sites.
   *
   * @param element its element in the file
   * @param terms factors by joint; empty if it is over sites
   * @param start its length where all coordinates are zero, as far as the terms do not count it
   * @param angle whether it is an angle
   * @param line over sites
   */
  record Tendon(
      Element element,
      Map<String, Double> terms,
      double start,
      boolean angle,
      Optional<MjcfLine> line) {}

  /** MuJoCo's mark of a length that it takes itself. */
  private static final double AUTOMATIC = -1;

  private final Map<String, Joint> joints = new LinkedHashMap<>();
  private final Map<String, Frame> inWorld;
  private final Map<String, Site> sites;
  private final Map<String, Geom> geoms;
  private final Map<String, Double> references;
  private final MjcfOptions options;
  private final RobotNumbers numbers;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final MjcfActuators actuators;
  private final RobotInertia inertia;
  private final MjcfArmatures armatures;
  private final List<Joint> rotors = new ArrayList<>();
  private final List<Loop> loops = new ArrayList<>();
  private final List<Coupling> couplings = new ArrayList<>();
  private final List<Force> forces = new ArrayList<>();
  private final Set<String> constraintNames = new HashSet<>();
  private final Set<String> forceNames = new HashSet<>();
  private final Set<Element> done = new HashSet<>();

  MjcfForces(
      List<Joint> joints,
      Map<String, Frame> inWorld,
      Map<String, Site> sites,
      Map<String, Geom> geoms,
      Map<String, Double> references,
      RobotInertia inertia,
      MjcfArmatures armatures,
      MjcfOptions options,
      RobotNumbers numbers,
      Diagnostics diagnostics,
      ImportLosses losses) {
    joints.forEach(joint -> this.joints.put(joint.name(), joint));
    this.inWorld = inWorld;
    this.sites = sites;
    this.geoms = geoms;
    this.references = references;
    this.options = options;
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
    this.inertia = inertia;
    this.armatures = armatures;
    actuators =
        new MjcfActuators(
            this.joints,
            sites,
            references,
            inertia,
            this::pose,
            forceNames,
            options.clamped(),
            numbers,
            losses);
  }

  List<Loop> loops() {
    return loops;
  }

  List<Coupling> couplings() {
    return couplings;
  }

  /**
   * Returns the joints of rotors that turn with tendons, between the world and links without mass
   * of their own; they exist only in these joints.
   */
  List<Joint> rotors() {
    return rotors;
  }

  /** Returns the forces, those of motors last. */
  List<Force> forces() {
    List<Force> all = new ArrayList<>(forces);
    all.removeIf(force -> force instanceof CouplingSpring spring && isIdle(spring));
    all.addAll(actuators.forces());
    return all;
  }

  /**
   * Returns whether a spring on one side never acts, because an equation holds its length where it
   * is slack. At the very end of its range it would begin and end to act with each rounding.
   */
  private boolean isIdle(CouplingSpring spring) {
    return held(spring.terms())
        .map(
            length ->
                (spring.side().equals("tension") && length <= spring.rest())
                    || (spring.side().equals("compression") && length >= spring.rest()))
        .orElse(false);
  }

  /** Returns the value at which an equation holds a sum of positions. */
  private Optional<Double> held(Map<String, Double> terms) {
    return couplings.stream()
        .filter(one -> one.expression().isEmpty() && one.terms().equals(terms))
        .map(Coupling::constant)
        .findFirst();
  }

  /** Returns a joint without limits that never act, because an equation holds it within. */
  Joint withoutIdleLimits(Joint joint) {
    boolean idle =
        held(Map.of(joint.name(), 1.0))
            .flatMap(
                position ->
                    joint
                        .coordinate()
                        .limits()
                        .map(range -> range.lower() <= position && position <= range.upper()))
            .orElse(false);
    return idle ? joint.with(joint.coordinate().unlimited()) : joint;
  }

  /**
   * Reads the equations, tendons and motors of one use of a model. A replica and an attached model
   * have those whose names all exist in it.
   */
  void read(MjcfReader.Scope scope) {
    boolean whole = scope.prefix().isEmpty() && scope.suffix().isEmpty();
    Map<String, Tendon> tendons = new HashMap<>();
    for (Element tendon : scope.file().all("tendon")) {
      if (isPart(scope, tendon, whole)) {
        readTendon(scope, tendon, tendons);
      }
    }
    for (Element equality : scope.file().all("equality")) {
      if (isPart(scope, equality, whole) && isActive(equality)) {
        readEquality(scope, equality, tendons);
      }
    }
    if (options.motors()) {
      for (Element actuator : scope.file().all("actuator")) {
        int group = (int) numbers.optional(actuator, "group", 0);
        if (isPart(scope, actuator, whole) && !options.silent().contains(group)) {
          actuators.read(scope, actuator, tendons);
        }
      }
    }
  }

  /** Elements of the file itself whose names only its replicas have belong to these. */
  private boolean isPart(MjcfReader.Scope scope, Element element, boolean whole) {
    boolean all = names(element).stream().allMatch(name -> exists(scope.named(name)));
    if (whole && !all) {
      boolean replicated =
          names(element).stream()
              .anyMatch(
                  name ->
                      joints.keySet().stream().anyMatch(known -> isReplica(known, name))
                          || inWorld.keySet().stream().anyMatch(known -> isReplica(known, name))
                          || geoms.keySet().stream().anyMatch(known -> isReplica(known, name))
                          || sites.keySet().stream().anyMatch(known -> isReplica(known, name)));
      return !replicated && done.add(element);
    }
    return whole ? done.add(element) : all && !isShared(scope, element);
  }

  private static boolean isReplica(String known, String name) {
    return known.startsWith(name) && known.substring(name.length()).matches(".*\\d+");
  }

  /** Returns whether an element of a replica has no name in it, so that it belongs to the file. */
  private boolean isShared(MjcfReader.Scope scope, Element element) {
    return !scope.suffix().isEmpty() && (names(element).isEmpty() || done.contains(element));
  }

  private boolean exists(String name) {
    return joints.containsKey(name)
        || inWorld.containsKey(name)
        || sites.containsKey(name)
        || geoms.containsKey(name);
  }

  /** Returns the names of joints, bodies and sites that an element has. */
  private static List<String> names(Element element) {
    List<String> all = new ArrayList<>();
    for (String attribute :
        List.of(
            "joint",
            "joint1",
            "joint2",
            "body1",
            "body2",
            "site1",
            "site2",
            "site",
            "sidesite",
            "geom",
            "body")) {
      element.attribute(attribute).ifPresent(all::add);
    }
    element.children().forEach(child -> all.addAll(names(child)));
    return all;
  }

  private boolean isActive(Element equality) {
    return options.equalities() && !equality.attribute("active").orElse("true").equals("false");
  }

  private String made(Element element, String wished, Set<String> taken) {
    String free = element.attribute("name").orElse(wished);
    while (!taken.add(free)) {
      free += "_";
    }
    return free;
  }

  private void unknown(Element asking, String kind, String name, Set<String> known) {
    diagnostics.error(
        MessageCode.UNKNOWN_NAME,
        asking.position(),
        Phrase.of(
            "%s: %s %s does not exist%s",
            asking.label(), kind, Quoted.of(name), NearestName.suggestion(name, known)));
  }

  private void readEquality(MjcfReader.Scope scope, Element equality, Map<String, Tendon> tendons) {
    switch (equality.name()) {
      case "connect", "weld" -> readLoop(scope, equality);
      case "joint" -> readJoints(scope, equality);
      case "tendon" -> readTendons(scope, equality, tendons);
      default -> {
        // Equations of deformable bodies are reported as lost.
      }
    }
  }

  private void readLoop(MjcfReader.Scope scope, Element equality) {
    boolean rigid = equality.name().equals("weld");
    Optional<Site> one = end(scope, equality, "1");
    Optional<Site> two = end(scope, equality, "2");
    if (one.isEmpty() || two.isEmpty()) {
      return;
    }
    Frame first = one.get().frame();
    Frame second = two.get().frame();
    if (equality.attribute("site1").isEmpty()) {
      Frame now = world(one.get()).inverse().times(world(two.get()));
      if (rigid) {
        List<Double> pose =
            equality
                .attribute("relpose")
                .map(text -> numbers.read(equality, "relpose", text, 7, 7))
                .orElse(List.of(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        boolean given = pose.subList(3, 7).stream().anyMatch(x -> x != 0);
        first =
            given
                ? new Frame(
                    new Vector3(pose.get(0), pose.get(1), pose.get(2)),
                    Frame.rotation(pose.get(3), pose.get(4), pose.get(5), pose.get(6)))
                : now;
      } else {
        if (equality.attribute("anchor").isEmpty()) {
          numbers.missing(equality, "attribute anchor");
        }
        Vector3 anchor = numbers.vector(equality, "anchor", Vector3.ZERO);
        first = new Frame(anchor, Rotation.IDENTITY);
        second = now.inverse().times(first);
      }
    }
    if (moves(one.get().link()).equals(moves(two.get().link()))) {
      return; // both ends are one body
    }
    String name = made(equality, equality.name() + (loops.size() + 1), constraintNames);
    loops.add(new Loop(equality, name, rigid, one.get().link(), first, two.get().link(), second));
  }

  /** Returns the last link on the way to the root that moves together with a link. */
  private String moves(String link) {
    String at = link;
    for (Joint joint = above(at);
        joint != null && joint.type() == Freedom.FIXED;
        joint = above(at)) {
      at = joint.parent();
    }
    return at;
  }

  private @Nullable Joint above(String link) {
    return joints.values().stream().filter(j -> j.child().equals(link)).findFirst().orElse(null);
  }

  private Frame world(Site site) {
    return pose(site.link(), site.frame());
  }

  /** Returns a frame of a link in the world, in the pose of the file. */
  private Frame pose(String link, Frame frame) {
    return inWorld.getOrDefault(link, Frame.SAME).times(frame);
  }

  private Optional<Site> end(MjcfReader.Scope scope, Element equality, String number) {
    Optional<String> site = equality.attribute("site" + number);
    if (site.isPresent()) {
      Optional<Site> found = Optional.ofNullable(sites.get(scope.named(site.get())));
      if (found.isEmpty()) {
        unknown(equality, "site", site.get(), sites.keySet());
      }
      return found;
    }
    String body = scope.named(equality.attribute("body" + number).orElse(MjcfReader.WORLD));
    if (!inWorld.containsKey(body)) {
      unknown(equality, "body", body, inWorld.keySet());
      return Optional.empty();
    }
    return Optional.of(new Site(body, Frame.SAME));
  }

  private Optional<Joint> single(MjcfReader.Scope scope, Element asking, String name) {
    Joint joint = joints.get(scope.named(name));
    if (joint == null) {
      unknown(asking, "joint", name, joints.keySet());
      return Optional.empty();
    }
    if (!joint.type().isSingle()) {
      numbers.contradiction(asking, "joint " + Quoted.of(name) + " is no hinge and no slide");
      return Optional.empty();
    }
    return Optional.of(joint);
  }

  private List<Double> polynomial(Element equality) {
    List<Double> c =
        new ArrayList<>(
            numbers.read(
                equality, "polycoef", equality.attribute("polycoef").orElse("0 1 0 0 0"), 1, 5));
    while (c.size() < 5) {
      c.add(0.0);
    }
    return c;
  }

  /** MuJoCo's polynomial is of deviations from the references, as coordinates are here. */
  private void readJoints(MjcfReader.Scope scope, Element equality) {
    if (equality.attribute("joint1").isEmpty()) {
      numbers.missing(equality, "attribute joint1");
      return;
    }
    Optional<Joint> follower = single(scope, equality, equality.attribute("joint1").orElse(""));
    Optional<Joint> other =
        equality.attribute("joint2").flatMap(name -> single(scope, equality, name));
    if (follower.isEmpty() || (other.isEmpty() && equality.attribute("joint2").isPresent())) {
      return;
    }
    List<Double> c = polynomial(equality);
    String name = follower.get().name();
    if (other.isEmpty()) {
      couplings.add(
          new Coupling(
              equality,
              made(equality, name + " held", constraintNames),
              Map.of(name, 1.0),
              Optional.empty(),
              c.get(0)));
      return;
    }
    String leader = other.get().name();
    addPolynomial(
        equality,
        made(equality, name + " follows " + leader, constraintNames),
        Map.of(name, 1.0),
        Map.of(leader, 1.0),
        c);
  }

  private void readTendons(MjcfReader.Scope scope, Element equality, Map<String, Tendon> tendons) {
    Optional<Tendon> follower = tendon(scope, equality, "tendon1", tendons);
    Optional<Tendon> other = tendon(scope, equality, "tendon2", tendons);
    boolean overSites =
        follower.filter(one -> one.line().isPresent()).isPresent()
            || other.filter(one -> one.line().isPresent()).isPresent();
    if (overSites
        || follower.isEmpty()
        || (other.isEmpty() && equality.attribute("tendon2").isPresent())) {
      losses.motion(equality, "it is left out: only tendons over joints are read");
      return;
    }
    List<Double> c = polynomial(equality);
    String name =
        made(equality, equality.attribute("tendon1").orElse("") + " follows", constraintNames);
    addPolynomial(
        equality, name, follower.get().terms(), other.map(Tendon::terms).orElse(Map.of()), c);
  }

  private Optional<Tendon> tendon(
      MjcfReader.Scope scope, Element asking, String attribute, Map<String, Tendon> tendons) {
    return asking
        .attribute(attribute)
        .flatMap(name -> Optional.ofNullable(tendons.get(scope.named(name))));
  }

  /** Adds the equation x = c0 + c1 y + c2 y² + …. */
  private void addPolynomial(
      Element element, String name, Map<String, Double> x, Map<String, Double> y, List<Double> c) {
    if (c.stream().skip(2).allMatch(k -> k == 0)) {
      Map<String, Double> terms = new LinkedHashMap<>(x);
      y.forEach((joint, factor) -> terms.merge(joint, -c.get(1) * factor, Double::sum));
      terms.values().removeIf(factor -> factor == 0);
      couplings.add(new Coupling(element, name, terms, Optional.empty(), c.get(0)));
      return;
    }
    String argument = "(" + MechmlText.sum(y, ".q") + ")";
    StringBuilder all = new StringBuilder(MechmlText.sum(x, ".q"));
    all.append(" - (").append(MechmlText.number(c.get(0))).append(")");
    for (int i = 1; i < c.size(); i++) {
      if (c.get(i) != 0) {
        all.append(" - (")
            .append(MechmlText.number(c.get(i)))
            .append(")*")
            .append(argument)
            .append(i == 1 ? "" : "^" + i);
      }
    }
    couplings.add(new Coupling(element, name, Map.of(), Optional.of(all.toString()), 0));
  }

  private void readTendon(MjcfReader.Scope scope, Element tendon, Map<String, Tendon> tendons) {
    if (options.friction() && numbers.optional(tendon, "frictionloss", 0) != 0) {
      losses.motion(tendon, "its frictionloss is left out");
    }
    if (tendon.name().equals("spatial") && numbers.optional(tendon, "armature", 0) != 0) {
      losses.motion(tendon, "its armature is left out: it is read at tendons over joints");
    }
    double stiffness = options.springs() ? first(tendon, "stiffness") : 0;
    double damping = options.dampers() ? first(tendon, "damping") : 0;
    Optional<List<Double>> range = range(scope, tendon);
    Optional<Tendon> read =
        tendon.name().equals("fixed") ? overJoints(scope, tendon) : overSites(scope, tendon);
    if (read.isEmpty()) {
      return;
    }
    tendon.attribute("name").ifPresent(name -> tendons.put(scope.named(name), read.get()));
    if (read.get().terms().size() > 1) {
      addRotor(tendon, read.get(), armatures.along(scope, tendon));
    }
    addSpring(tendon, read.get(), stiffness, damping);
    range.ifPresent(ends -> addLimits(tendon, read.get(), ends));
  }

  /** Adds the inertia along a tendon over several joints as a rotor that turns by its length. */
  private void addRotor(Element element, Tendon tendon, double armature) {
    if (!(armature > 0)) {
      return;
    }
    Set<String> taken = new HashSet<>(joints.keySet());
    taken.addAll(inWorld.keySet());
    rotors.forEach(other -> taken.add(other.name()));
    String name = element.attribute("name").orElse("tendon") + " rotor";
    while (!taken.add(name)) {
      name += "_";
    }
    rotors.add(
        new Joint(
            element,
            name,
            tendon.angle() ? Freedom.CONTINUOUS : Freedom.PRISMATIC,
            MjcfReader.WORLD,
            name,
            Place.at(Frame.SAME, new Vector3(1, 0, 0)),
            Coordinate.FREE.armed(armature)));
    Map<String, Double> terms = new LinkedHashMap<>(Map.of(name, 1.0));
    tendon.terms().forEach((joint, factor) -> terms.put(joint, -factor));
    couplings.add(
        new Coupling(element, made(element, name, constraintNames), terms, Optional.empty(), 0));
  }

  private Optional<List<Double>> range(MjcfReader.Scope scope, Element tendon) {
    String limited = tendon.attribute("limited").orElse("auto");
    boolean holds =
        options.limits()
            && (limited.equals("true")
                || (limited.equals("auto") && scope.compiler().autolimits()));
    return tendon
        .attribute("range")
        .filter(text -> holds)
        .map(text -> numbers.read(tendon, "range", text, 2, 2));
  }

  private Optional<Tendon> overJoints(MjcfReader.Scope scope, Element tendon) {
    Map<String, Double> terms = new LinkedHashMap<>();
    double start = 0;
    boolean angle = true;
    for (Element part : tendon.children("joint")) {
      Optional<Joint> joint = single(scope, part, part.attribute("joint").orElse(""));
      if (joint.isEmpty()) {
        return Optional.empty();
      }
      double factor = numbers.required(part, "coef");
      terms.merge(joint.get().name(), factor, Double::sum);
      start += factor * references.getOrDefault(joint.get().name(), 0.0);
      angle &= joint.get().type() != Freedom.PRISMATIC;
    }
    return Optional.of(new Tendon(tendon, terms, start, angle, Optional.empty()));
  }

  /** Returns a tendon over sites and shapes; empty after a reported error. */
  private Optional<Tendon> overSites(MjcfReader.Scope scope, Element tendon) {
    List<Waypoint> stops = new ArrayList<>();
    for (Element part : tendon.children()) {
      Optional<Waypoint> stop =
          switch (part.name()) {
            case "site" -> site(scope, part, "site").map(one -> (Waypoint) one.eye());
            case "geom" -> shape(scope, part);
            default -> {
              double divisor = numbers.required(part, "divisor");
              if (!(divisor > 0)) {
                numbers.contradiction(part, "divisor is " + divisor + "; it must be positive");
              }
              yield divisor > 0
                  ? Optional.of((Waypoint) new Branch(1 / divisor))
                  : Optional.empty();
            }
          };
      if (stop.isEmpty()) {
        return Optional.empty();
      }
      stops.add(stop.get());
    }
    for (int i = 0; i < stops.size(); i++) {
      boolean between =
          i > 0
              && i < stops.size() - 1
              && stops.get(i - 1) instanceof Eye
              && stops.get(i + 1) instanceof Eye;
      if (!(stops.get(i) instanceof Eye) && !between) {
        numbers.contradiction(
            tendon.children().get(i), "it stands between no two sites of its tendon");
        return Optional.empty();
      }
    }
    if (stops.size() < 2) {
      numbers.missing(tendon, "two sites");
      return Optional.empty();
    }
    return Optional.of(new Tendon(tendon, Map.of(), 0, false, Optional.of(new MjcfLine(stops))));
  }

  private Optional<Site> site(MjcfReader.Scope scope, Element part, String attribute) {
    String name = part.attribute(attribute).orElse("");
    Optional<Site> site = Optional.ofNullable(sites.get(scope.named(name)));
    if (site.isEmpty()) {
      unknown(part, "site", name, sites.keySet());
    }
    return site;
  }

  private Optional<Waypoint> shape(MjcfReader.Scope scope, Element part) {
    String name = part.attribute("geom").orElse("");
    Geom geom = geoms.get(scope.named(name));
    if (geom == null) {
      unknown(part, "geom", name, geoms.keySet());
      return Optional.empty();
    }
    String type = geom.element().attribute("type").orElse("sphere");
    if (!type.equals("sphere") && !type.equals("cylinder")) {
      numbers.contradiction(
          part,
          "geom "
              + Quoted.of(name)
              + " is a "
              + type
              + "; tendons go around spheres and"
              + " cylinders");
      return Optional.empty();
    }
    Optional<Site> side = Optional.empty();
    if (part.attribute("sidesite").isPresent()) {
      side = site(scope, part, "sidesite");
      if (side.isEmpty()) {
        return Optional.empty();
      }
    }
    double radius =
        geom.element()
            .attribute("size")
            .map(text -> numbers.read(geom.element(), "size", text, 1, 3).get(0))
            .orElse(0.0);
    if (!(radius > 0) || geom.element().attribute("mesh").isPresent()) {
      losses.motion(part, "it is left out: geom " + Quoted.of(name) + " has no size of its own");
      return Optional.empty();
    }
    boolean inside = false;
    if (side.isPresent()) {
      Frame centre = world(new Site(geom.link(), geom.frame()));
      inside = world(side.get()).at().minus(centre.at()).norm() < radius;
      if (!moves(side.get().link()).equals(moves(geom.link()))) {
        losses.motion(
            part, "sidesite counts as " + (inside ? "inside" : "outside") + " of the geom always");
      }
    }
    return Optional.of(
        new Around(
            geom.link(),
            geom.frame(),
            type.equals("cylinder"),
            radius,
            side.map(Site::eye),
            inside));
  }

  private double first(Element element, String name) {
    List<Double> read =
        element
            .attribute(name)
            .map(text -> numbers.read(element, name, text, 1, 8))
            .orElse(List.of(0.0));
    if (read.stream().skip(1).anyMatch(x -> x != 0)) {
      losses.motion(element, "the higher powers of " + name + " are left out");
    }
    return read.get(0);
  }

  private void addSpring(Element element, Tendon tendon, double stiffness, double damping) {
    List<Double> lengths =
        element
            .attribute("springlength")
            .map(text -> numbers.read(element, "springlength", text, 1, 2))
            .orElse(List.of(AUTOMATIC));
    boolean given = lengths.get(0) != AUTOMATIC;
    double low = given ? lengths.get(0) - tendon.start() : free(element, tendon, stiffness);
    double high = given && lengths.size() > 1 ? lengths.get(1) - tendon.start() : low;
    boolean slack = high > low;
    List<Eye> ends = tendon.line().flatMap(MjcfLine::straight).orElse(List.of());
    if (!ends.isEmpty() && !slack && (stiffness != 0 || damping != 0)) {
      forces.add(
          new PointSpring(
              element,
              made(element, "tendon", forceNames),
              ends.get(0).link(),
              ends.get(0).at(),
              ends.get(1).link(),
              ends.get(1).at(),
              stiffness,
              damping,
              low));
      return;
    }
    if ((slack || stiffness == 0) && damping != 0) {
      add(element, tendon, "damper", 0, damping, 0, "both");
    }
    if (slack && stiffness != 0) {
      add(element, tendon, "spring", stiffness, 0, high, "tension");
      if (tendon.line().isEmpty() || low > 0) {
        add(element, tendon, "spring", stiffness, 0, low, "compression");
      }
    } else if (stiffness != 0) {
      add(element, tendon, "spring", stiffness, damping, low, "both");
    }
  }

  /** Returns the length where all joints are at the free positions of their springs. */
  private double free(Element element, Tendon tendon, double stiffness) {
    double free = 0;
    for (Map.Entry<String, Double> term : tendon.terms().entrySet()) {
      Joint joint = joints.get(term.getKey());
      free += joint == null ? 0 : term.getValue() * joint.coordinate().freePosition();
    }
    if (tendon.line().isPresent()) {
      boolean moved =
          joints.values().stream().anyMatch(joint -> joint.coordinate().freePosition() != 0);
      if (moved && stiffness != 0) {
        losses.motion(
            element,
            "its free length is that in the pose of the file: springref of joints is left out");
      }
      free = tendon.line().get().length(this::pose);
    }
    return free;
  }

  /** Adds the limits of a tendon: springs that act beyond its range, as stops of joints do. */
  private void addLimits(Element element, Tendon tendon, List<Double> range) {
    List<Double> given =
        element
            .attribute("solreflimit")
            .map(text -> numbers.read(element, "solreflimit", text, 2, 2))
            .orElse(MjcfJointReader.SOLREF);
    Stop stop = Stop.of(given.get(0), given.get(1));
    if (stop.isAssumed()) {
      stop = Stop.of(MjcfJointReader.SOLREF.get(0), MjcfJointReader.SOLREF.get(1));
    }
    double held =
        tendon
            .line()
            .map(line -> inertia.free(line.pulls(this::pose)))
            .orElseGet(() -> inertia.free(tendon.terms()));
    double m = held > 0 ? held : 1;
    double stiffness = m / Math.pow(stop.time() * stop.ratio(), 2);
    double damping = 2 * m / stop.time();
    double low = range.get(0) - tendon.start();
    double high = range.get(1) - tendon.start();
    add(element, tendon, "upper limit", stiffness, damping, high, "tension");
    if (tendon.line().isEmpty() || low > 0) {
      add(element, tendon, "lower limit", stiffness, damping, low, "compression");
    }
  }

  private void add(
      Element element,
      Tendon tendon,
      String what,
      double stiffness,
      double damping,
      double rest,
      String side) {
    String name = made(element, "tendon " + what, forceNames);
    forces.add(
        tendon.line().isPresent()
            ? new PathSpring(
                element, name, tendon.line().get().stops(), stiffness, damping, rest, side)
            : new CouplingSpring(
                element, name, tendon.angle(), tendon.terms(), stiffness, damping, rest, side));
  }
}
