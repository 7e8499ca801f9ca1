package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.MjcfForces.Site;
import org.mechservice.robot.MjcfForces.Tendon;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Input;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.JointForce;
import org.mechservice.robot.Robot.Muscle;
import org.mechservice.robot.Robot.PathTension;
import org.mechservice.robot.Robot.State;
import org.mechservice.solver.spatial.Vector3;

/**
 * The motors and servos of an MJCF model: each is an input u, zero until somebody sets it, and the
 * force gain · u + bias along joints. With a time constant a state that follows u takes its place.
 * The bias of a servo acts also where nobody commands it.
 *
 * <p>Source: MuJoCo documentation, Computation, "Actuation model": the force is limited to {@code
 * forcerange}, the input to {@code ctrlrange}; the length of a joint's actuator is gear · position,
 * and the force on the joint is gear · force.
 */
final class MjcfActuators {
  /** MuJoCo's kinds of actuators that are a law of this form. */
  private static final Set<String> READ =
      Set.of("motor", "position", "velocity", "intvelocity", "damper", "cylinder", "general");

  /** Time in which an integrated command comes to its bound at the most, s. */
  private static final double AT_BOUND = 1e-3;

  /** Force on a joint from all its motors. */
  private record Sum(Element element, List<String> parts) {}

  /** How an input becomes what acts. */
  private enum Activation {
    /** At once. */
    NONE,
    /** With a delay of the first order. */
    FILTER,
    /** As its integral over time. */
    INTEGRAL
  }

  /**
   * The force of an actuator: (g₀ + g₁ length + g₂ velocity) u + a₀ + a₁ length + a₂ velocity.
   *
   * @param dampingRatio from which MuJoCo makes a₂; 0 if that is given
   * @param activation how the input acts
   * @param time constant of a delay, s
   */
  private record Law(
      List<Double> gain,
      List<Double> bias,
      double dampingRatio,
      Activation activation,
      double time) {
    Law(double gain, List<Double> bias) {
      this(List.of(gain, 0.0, 0.0), bias, 0, Activation.NONE, 0);
    }

    /** Returns the law with the damping for an inertia as the actuator sees it. */
    Law damped(double inertia) {
      double damping = 2 * dampingRatio * Math.sqrt(-bias.get(1) * inertia);
      return new Law(gain, List.of(bias.get(0), bias.get(1), -damping), 0, activation, time);
    }

    Law delayed(double seconds) {
      Activation delay = seconds > 0 ? Activation.FILTER : Activation.NONE;
      return new Law(gain, bias, dampingRatio, delay, seconds);
    }

    Law integrated() {
      return new Law(gain, bias, dampingRatio, Activation.INTEGRAL, 0);
    }

    Law by(double ratio) {
      return new Law(gain, bias, ratio, activation, time);
    }

    boolean actsAlone() {
      return bias.stream().anyMatch(x -> x != 0);
    }

    /** Returns whether the input is a length that the actuator follows. */
    boolean isServo() {
      return gain.equals(List.of(-bias.get(1), 0.0, 0.0));
    }

    boolean feelsMotion() {
      return gain.get(2) != 0 || bias.get(2) != 0 || dampingRatio != 0;
    }
  }

  /** Where an actuator pulls. */
  private interface Transmission {
    /** Returns its length in MechML, without a constant. */
    String length();

    /** Returns the constant part of the length. */
    default double offset() {
      return 0;
    }

    /** Returns the rate of the length in MechML; empty if the import has no expression for it. */
    Optional<String> velocity();

    /** Returns the inertia that it moves; 0 if it is not defined. */
    double inertia();

    /** Returns whether its length is an angle. */
    boolean turns();

    /** Lets a force act. */
    void act(Element actuator, String name, String force);

    /**
     * Returns how fast the joints would move in a second if a unit of force acted for that long, as
     * MuJoCo measures it for muscles; 0 if it is not defined.
     */
    double mobility();

    /** Returns the muscle that pulls here; empty if the import has none such. */
    Optional<Muscle> muscle(
        Element actuator, String name, String excitation, Map<String, Double> given);
  }

  /** What an actuator may act on. */
  private static final List<String> TARGETS =
      List.of("joint", "jointinparent", "tendon", "site", "body", "cranksite");

  private final Map<String, Joint> joints;
  private final Map<String, Site> sites;
  private final Map<String, Double> references;
  private final RobotInertia inertia;
  private final MjcfLine.Placing placing;
  private final Set<String> forceNames;
  private final boolean clampsInputs;
  private final RobotNumbers numbers;
  private final ImportLosses losses;
  private final List<Force> inputs = new ArrayList<>();
  private final List<Force> pulls = new ArrayList<>();
  private final Map<String, Sum> sums = new LinkedHashMap<>();
  private final Set<String> names = new HashSet<>();

  MjcfActuators(
      Map<String, Joint> joints,
      Map<String, Site> sites,
      Map<String, Double> references,
      RobotInertia inertia,
      MjcfLine.Placing placing,
      Set<String> forceNames,
      boolean clampsInputs,
      RobotNumbers numbers,
      ImportLosses losses) {
    this.joints = joints;
    this.sites = sites;
    this.references = references;
    this.inertia = inertia;
    this.placing = placing;
    this.forceNames = forceNames;
    this.clampsInputs = clampsInputs;
    this.numbers = numbers;
    this.losses = losses;
  }

  /** Returns the inputs, then the forces. */
  List<Force> forces() {
    List<Force> all = new ArrayList<>(inputs);
    all.addAll(pulls);
    joints.values().stream()
        .map(Joint::element)
        .filter(joint -> !pulls.isEmpty() && limit(joint).isPresent())
        .forEach(
            joint ->
                losses.motion(
                    joint,
                    "its actuatorfrcrange does not hold for motors of tendons over sites and of"
                        + " sites"));
    sums.forEach(
        (name, sum) -> {
          String force = String.join(" + ", sum.parts());
          Optional<List<Double>> limit = limit(joint(name).element());
          if (limit.isPresent()) {
            force = clamped(force, limit.get());
          }
          all.add(new JointForce(sum.element(), name + " motor", name, force));
        });
    return all;
  }

  /** Returns the limits of the sum of all motors of a joint. */
  private Optional<List<Double>> limit(Element joint) {
    boolean off = joint.attribute("actuatorfrclimited").orElse("auto").equals("false");
    return joint
        .attribute("actuatorfrcrange")
        .filter(text -> !off)
        .map(text -> numbers.read(joint, "actuatorfrcrange", text, 2, 2));
  }

  private Joint joint(String name) {
    return Optional.ofNullable(joints.get(name)).orElseThrow();
  }

  private static String clamped(String force, List<Double> range) {
    return "max("
        + MechmlText.number(range.get(0))
        + ", min("
        + MechmlText.number(range.get(1))
        + ", "
        + force
        + "))";
  }

  /** Reads an actuator. */
  void read(MjcfReader.Scope scope, Element actuator, Map<String, Tendon> tendons) {
    if (actuator.name().equals("adhesion")) {
      losses.contact(actuator, "left out: it acts where its body touches another");
      return;
    }
    if (TARGETS.stream().allMatch(target -> actuator.attribute(target).isEmpty())) {
      numbers.missing(actuator, "a joint, tendon, site or body to act on");
      return;
    }
    if (MjcfMuscle.is(actuator)) {
      readMuscle(scope, actuator, tendons);
      return;
    }
    Optional<Law> law = law(actuator);
    if (law.isEmpty()) {
      losses.motion(actuator, "a motor of this kind is left out");
      return;
    }
    Optional<Transmission> found = transmission(scope, actuator, tendons);
    boolean still = found.filter(way -> way.velocity().isEmpty()).isPresent();
    if (found.isEmpty() || (still && law.get().feelsMotion())) {
      LossGrade grade = law.get().actsAlone() ? LossGrade.MOTION : LossGrade.CONTACT;
      losses.add(
          grade,
          actuator,
          "it is left out: only motors of hinges, slides and tendons, and forces at free joints and"
              + " sites are read");
      return;
    }
    Transmission way = found.get();
    Law acting = law.get();
    if (acting.dampingRatio() != 0) {
      acting = acting.damped(way.inertia());
    }
    addForce(actuator, scope, acting, way, inherited(scope, actuator, acting, tendons));
  }

  /**
   * Returns the range that a servo inherits: that of its joint or tendon, made wider or narrower
   * about its middle. A general actuator inherits it in place of its own, others if they have none.
   * MuJoCo turns that of a joint into radians if it is a limit.
   */
  private Optional<List<Double>> inherited(
      MjcfReader.Scope scope, Element actuator, Law law, Map<String, Tendon> tendons) {
    double share = numbers.optional(actuator, "inheritrange", 0);
    String range = law.activation() == Activation.INTEGRAL ? "actrange" : "ctrlrange";
    boolean own = !actuator.name().equals("general") && actuator.attribute(range).isPresent();
    if (!(share > 0) || !law.isServo() || own) {
      return Optional.empty();
    }
    Optional<Joint> joint =
        actuator
            .attribute("joint")
            .flatMap(name -> Optional.ofNullable(joints.get(scope.named(name))));
    Optional<Element> target =
        joint
            .map(Joint::element)
            .or(
                () ->
                    actuator
                        .attribute("tendon")
                        .flatMap(name -> Optional.ofNullable(tendons.get(scope.named(name))))
                        .map(Tendon::element));
    boolean turns = joint.filter(one -> one.type() != Freedom.PRISMATIC).isPresent();
    String limited = target.flatMap(one -> one.attribute("limited")).orElse("auto");
    boolean limits =
        limited.equals("true") || (limited.equals("auto") && scope.compiler().autolimits());
    double unit = turns && limits ? scope.compiler().angle() : 1;
    Optional<List<Double>> inherited =
        target.flatMap(
            one -> one.attribute("range").map(text -> numbers.read(one, "range", text, 2, 2)));
    if (inherited.isEmpty()) {
      numbers.contradiction(
          actuator, "inheritrange is " + share + ", and its joint or tendon has no range");
    }
    return inherited.map(
        ends -> {
          double middle = unit * (ends.get(0) + ends.get(1)) / 2;
          double half = share * unit * (ends.get(1) - ends.get(0)) / 2;
          return List.of(middle - half, middle + half);
        });
  }

  private Optional<Transmission> transmission(
      MjcfReader.Scope scope, Element actuator, Map<String, Tendon> tendons) {
    List<Double> gear = new ArrayList<>(numbers.several(actuator, "gear"));
    if (gear.isEmpty()) {
      gear.add(1.0);
    }
    while (gear.size() < 6) {
      gear.add(0.0);
    }
    Optional<String> inParent = actuator.attribute("jointinparent");
    Optional<String> single = actuator.attribute("joint").or(() -> inParent);
    Optional<Tendon> tendon =
        actuator
            .attribute("tendon")
            .flatMap(name -> Optional.ofNullable(tendons.get(scope.named(name))));
    Optional<String> site = actuator.attribute("site");
    if (single.isPresent()) {
      Joint joint = joints.get(scope.named(single.get()));
      if (joint == null) {
        numbers.contradiction(actuator, "joint \"" + single.get() + "\" does not exist");
        return Optional.empty();
      }
      if (joint.type().isSingle()) {
        return Optional.of(alongJoints(Map.of(joint.name(), gear.get(0))));
      }
      return joint.type() == Freedom.FLOATING && inParent.isEmpty()
          ? Optional.of(atFree(joint, gear))
          : Optional.empty();
    }
    if (tendon.isPresent()) {
      double factor = gear.get(0);
      if (tendon.get().line().isPresent()) {
        return Optional.of(alongLine(tendon.get().line().get(), factor));
      }
      Map<String, Double> moments = new LinkedHashMap<>();
      tendon.get().terms().forEach((joint, each) -> moments.put(joint, factor * each));
      return Optional.of(alongJoints(moments));
    }
    if (site.isPresent() && actuator.attribute("refsite").isEmpty()) {
      return Optional.ofNullable(sites.get(scope.named(site.get()))).map(at -> atSite(at, gear));
    }
    return Optional.empty();
  }

  private Transmission alongJoints(Map<String, Double> moments) {
    double constant = 0;
    for (Map.Entry<String, Double> moment : moments.entrySet()) {
      constant += moment.getValue() * references.getOrDefault(moment.getKey(), 0.0);
    }
    double offset = constant;
    return new Transmission() {
      @Override
      public String length() {
        return MechmlText.sum(moments, ".q");
      }

      @Override
      public double offset() {
        return offset;
      }

      @Override
      public Optional<String> velocity() {
        return Optional.of(MechmlText.sum(moments, ".v"));
      }

      @Override
      public double inertia() {
        if (moments.size() > 1) {
          return inertia.free(moments);
        }
        Map.Entry<String, Double> only = moments.entrySet().iterator().next();
        return inertia.free(only.getKey()) / (only.getValue() * only.getValue());
      }

      @Override
      public boolean turns() {
        return moments.keySet().stream().allMatch(name -> joint(name).type() != Freedom.PRISMATIC);
      }

      @Override
      public double mobility() {
        return inertia.mobility(moments);
      }

      @Override
      public Optional<Muscle> muscle(
          Element actuator, String name, String excitation, Map<String, Double> given) {
        Map<String, Double> numbers = new LinkedHashMap<>(given);
        numbers.computeIfPresent("shortest", (key, length) -> length - offset);
        numbers.computeIfPresent("longest", (key, length) -> length - offset);
        return Optional.of(
            new Muscle(actuator, forceName(name), List.of(), moments, excitation, numbers));
      }

      @Override
      public void act(Element actuator, String name, String force) {
        moments.forEach(
            (joint, factor) ->
                sums.computeIfAbsent(joint, key -> new Sum(actuator, new ArrayList<>()))
                    .parts()
                    .add(factor == 1 ? force : "(" + MechmlText.number(factor) + ")*" + force));
      }
    };
  }

  private Transmission alongLine(MjcfLine line, double factor) {
    return new Transmission() {
      private String times(String text) {
        return factor == 1 ? text : "(" + MechmlText.number(factor) + ")*" + text;
      }

      @Override
      public String length() {
        return times("length");
      }

      @Override
      public Optional<String> velocity() {
        return Optional.of(times("rate"));
      }

      @Override
      public double inertia() {
        return 0;
      }

      @Override
      public boolean turns() {
        return false;
      }

      @Override
      public void act(Element actuator, String name, String force) {
        // a tension acts against growing length, MuJoCo's force along it
        String tension = "-" + times(force);
        pulls.add(new PathTension(actuator, forceName(name), line.stops(), tension));
      }

      @Override
      public double mobility() {
        return Math.abs(factor) * inertia.mobility(line.pulls(placing));
      }

      @Override
      public Optional<Muscle> muscle(
          Element actuator, String name, String excitation, Map<String, Double> given) {
        return factor > 0
            ? Optional.of(
                new Muscle(
                    actuator,
                    forceName(name),
                    line.stops(),
                    Map.of(),
                    excitation,
                    scaled(given, factor)))
            : Optional.empty();
      }
    };
  }

  /** Returns the numbers of a muscle on the length of its path, of which a gear makes more. */
  private static Map<String, Double> scaled(Map<String, Double> given, double gear) {
    Map<String, Double> numbers = new LinkedHashMap<>(given);
    numbers.computeIfPresent("shortest", (name, length) -> length / gear);
    numbers.computeIfPresent("longest", (name, length) -> length / gear);
    numbers.computeIfPresent("force", (name, force) -> force * gear);
    return numbers;
  }

  private String forceName(String name) {
    String free = name;
    while (!forceNames.add(free)) {
      free += "_";
    }
    return free;
  }

  /** The force in world axes and the torque in the link's axes that act at a free joint's link. */
  private Transmission atFree(Joint joint, List<Double> gear) {
    Vector3 force = new Vector3(gear.get(0), gear.get(1), gear.get(2));
    Vector3 torque = new Vector3(gear.get(3), gear.get(4), gear.get(5));
    return atPoint(joint.child(), Vector3.ZERO, force, false, torque);
  }

  /** The force and torque in the axes of a site. */
  private Transmission atSite(Site site, List<Double> gear) {
    Vector3 force = new Vector3(gear.get(0), gear.get(1), gear.get(2));
    Vector3 torque = new Vector3(gear.get(3), gear.get(4), gear.get(5));
    return atPoint(
        site.link(),
        site.frame().at(),
        site.frame().turn().apply(force),
        true,
        site.frame().turn().apply(torque));
  }

  /**
   * @param turning whether the force is in the link's axes, as the torque is
   */
  private Transmission atPoint(
      String link, Vector3 at, Vector3 force, boolean turning, Vector3 torque) {
    return new Transmission() {
      @Override
      public String length() {
        return "0"; // without a reference a site has no place that would count
      }

      @Override
      public Optional<String> velocity() {
        return Optional.empty();
      }

      @Override
      public double inertia() {
        return 0;
      }

      @Override
      public boolean turns() {
        return force.equals(Vector3.ZERO);
      }

      @Override
      public double mobility() {
        return 0;
      }

      @Override
      public Optional<Muscle> muscle(
          Element actuator, String name, String excitation, Map<String, Double> given) {
        return Optional.empty();
      }

      @Override
      public void act(Element actuator, String name, String strength) {
        if (!force.equals(Vector3.ZERO)) {
          pulls.add(
              new BodyForce(
                  actuator, name + " force", link, at, turning, times(force, strength), List.of()));
        }
        if (!torque.equals(Vector3.ZERO)) {
          List<String> none = List.of("0", "0", "0");
          pulls.add(
              new BodyForce(
                  actuator, name + " torque", link, at, true, none, times(torque, strength)));
        }
      }
    };
  }

  private static List<String> times(Vector3 v, String strength) {
    return List.of(
        "(" + MechmlText.number(v.x()) + ")*" + strength,
        "(" + MechmlText.number(v.y()) + ")*" + strength,
        "(" + MechmlText.number(v.z()) + ")*" + strength);
  }

  private void readMuscle(MjcfReader.Scope scope, Element actuator, Map<String, Tendon> tendons) {
    Optional<Map<String, Double>> read = new MjcfMuscle(numbers).read(actuator);
    Optional<List<Double>> range =
        actuator
            .attribute("lengthrange")
            .map(text -> numbers.read(actuator, "lengthrange", text, 2, 2))
            .filter(ends -> ends.get(0) < ends.get(1));
    Optional<Transmission> way = transmission(scope, actuator, tendons);
    if (read.isEmpty() || range.isEmpty() || way.isEmpty()) {
      losses.motion(
          actuator,
          read.isEmpty()
              ? "it is left out: its gain, bias and dynamics are not all those of one muscle"
              : range.isEmpty()
                  ? "it is left out: it has no lengthrange, which MuJoCo finds by simulation; save"
                      + " the model from MuJoCo"
                  : "it is left out: muscles act on hinges, slides and tendons here");
      return;
    }
    Map<String, Double> given = read.get();
    double force = given.getOrDefault("force", -1.0);
    if (force < 0) {
      force = given.getOrDefault("scale", 0.0) / Math.max(1e-15, way.get().mobility());
    }
    given.put("force", force);
    given.remove("scale");
    given.put("shortest", range.get().get(0));
    given.put("longest", range.get().get(1));
    String name = inputName(actuator, scope);
    Optional<Muscle> muscle = way.get().muscle(actuator, name, excitation(actuator, name), given);
    if (muscle.isEmpty()
        || range(actuator, "force").isPresent()
        || actuator.attribute("actearly").filter("true"::equals).isPresent()) {
      losses.motion(
          actuator,
          muscle.isEmpty()
              ? "it is left out: muscles act on hinges, slides and tendons with a positive gear here"
              : "its forcerange and actearly are left out");
    }
    inputs.add(new Input(actuator, name, "1"));
    muscle.ifPresent(pulls::add);
  }

  private String excitation(Element actuator, String name) {
    return command(MechmlText.name(name), range(actuator, "ctrl"));
  }

  /** Returns a name for the input of an actuator. */
  private String inputName(Element actuator, MjcfReader.Scope scope) {
    String target =
        actuator
            .attribute("joint")
            .or(() -> actuator.attribute("jointinparent"))
            .or(() -> actuator.attribute("tendon"))
            .or(() -> actuator.attribute("site"))
            .map(scope::named)
            .orElse("");
    String name =
        actuator.attribute("name").map(scope::named).orElse(target + " " + actuator.name());
    while (!names.add(name)) {
      name += "_";
    }
    return name;
  }

  private void addForce(
      Element actuator,
      MjcfReader.Scope scope,
      Law law,
      Transmission way,
      Optional<List<Double>> inherited) {
    String name = inputName(actuator, scope);
    boolean speeds = actuator.name().matches("velocity|intvelocity");
    boolean commands = speeds || actuator.name().equals("position");
    boolean turns = way.turns();
    String unit = commands ? (turns ? "rad" : "m") : turns ? "N*m" : "N";
    String signal = actuator.name().matches("general|damper|cylinder") ? "1" : unit;
    inputs.add(new Input(actuator, name, speeds ? unit + "/s" : signal));
    String u = MechmlText.name(name);
    boolean integrates = law.activation() == Activation.INTEGRAL;
    u = command(u, inherited.filter(r -> !integrates).or(() -> range(actuator, "ctrl")));
    if (law.activation() != Activation.NONE) {
      String follower = name + " activation";
      while (!names.add(follower)) {
        follower += "_";
      }
      String activation = MechmlText.name(follower);
      String rate =
          law.activation() == Activation.FILTER
              ? "(" + u + " - " + activation + ")/(" + MechmlText.number(law.time()) + ")"
              : bounded(activation, u, inherited.or(() -> range(actuator, "act")));
      inputs.add(new State(actuator, follower, signal, rate));
      u = activation;
    }
    String force = force(law, way, u);
    Optional<List<Double>> limits = range(actuator, "force");
    way.act(actuator, name, limits.map(r -> clamped(force, r)).orElse("(" + force + ")"));
  }

  /** Returns an input within its range, as far as ranges of inputs hold. */
  private String command(String input, Optional<List<Double>> range) {
    return range.filter(ends -> clampsInputs).map(ends -> clamped(input, ends)).orElse(input);
  }

  /** Returns the rate of an integral that its bounds hold back. */
  private static String bounded(String integral, String rate, Optional<List<Double>> bounds) {
    if (bounds.isEmpty()) {
      return rate;
    }
    List<String> ends =
        bounds.get().stream()
            .map(
                end ->
                    "("
                        + MechmlText.number(end)
                        + " - "
                        + integral
                        + ")/"
                        + MechmlText.number(AT_BOUND))
            .toList();
    return "max(" + ends.get(0) + ", min(" + ends.get(1) + ", " + rate + "))";
  }

  private static String force(Law law, Transmission way, String u) {
    List<String> parts = new ArrayList<>();
    addAffine(parts, law.gain(), way, "*" + u);
    addAffine(parts, law.bias(), way, "");
    return parts.isEmpty() ? "0" : String.join(" + ", parts);
  }

  private static void addAffine(
      List<String> parts, List<Double> factors, Transmission way, String behind) {
    double constant = factors.get(0) + factors.get(1) * way.offset();
    if (constant != 0) {
      parts.add("(" + MechmlText.number(constant) + ")" + behind);
    }
    if (factors.get(1) != 0) {
      parts.add("(" + MechmlText.number(factors.get(1)) + ")*(" + way.length() + ")" + behind);
    }
    if (factors.get(2) != 0) {
      String velocity = way.velocity().orElseThrow();
      parts.add("(" + MechmlText.number(factors.get(2)) + ")*(" + velocity + ")" + behind);
    }
  }

  private Optional<List<Double>> range(Element actuator, String what) {
    if (actuator.attribute(what + "limited").orElse("auto").equals("false")) {
      return Optional.empty();
    }
    return actuator
        .attribute(what + "range")
        .map(text -> numbers.read(actuator, what + "range", text, 2, 2))
        .filter(ends -> ends.get(0) < ends.get(1));
  }

  /** Returns the law of an actuator; empty if it has another one than a sum. */
  private Optional<Law> law(Element actuator) {
    if (!READ.contains(actuator.name())) {
      return Optional.empty();
    }
    List<Double> none = List.of(0.0, 0.0, 0.0);
    return switch (actuator.name()) {
      case "motor" -> Optional.of(new Law(1, none));
      case "position" ->
          Optional.of(servo(actuator).delayed(numbers.optional(actuator, "timeconst", 0)));
      case "intvelocity" -> Optional.of(servo(actuator).integrated());
      case "velocity" -> {
        double kv = numbers.optional(actuator, "kv", 1);
        yield Optional.of(new Law(kv, List.of(0.0, 0.0, -kv)));
      }
      case "damper" -> {
        double kv = numbers.optional(actuator, "kv", 1);
        yield Optional.of(new Law(List.of(0.0, 0.0, -kv), none, 0, Activation.NONE, 0));
      }
      case "cylinder" -> {
        double area = numbers.optional(actuator, "area", 1);
        if (actuator.attribute("diameter").isPresent()) {
          double diameter = numbers.optional(actuator, "diameter", 0);
          area = Math.PI / 4 * diameter * diameter;
        }
        yield Optional.of(
            new Law(area, three(actuator, "bias"))
                .delayed(numbers.optional(actuator, "timeconst", 1)));
      }
      default -> general(actuator);
    };
  }

  private Law servo(Element actuator) {
    double kp = numbers.optional(actuator, "kp", 1);
    double kv = numbers.optional(actuator, "kv", 0);
    return new Law(kp, List.of(0.0, -kp, -kv)).by(numbers.optional(actuator, "dampratio", 0));
  }

  private Optional<Law> general(Element actuator) {
    String gain = actuator.attribute("gaintype").orElse("fixed");
    String bias = actuator.attribute("biastype").orElse("none");
    String dynamics = actuator.attribute("dyntype").orElse("none");
    if (!Set.of("fixed", "affine").contains(gain)
        || !Set.of("none", "affine").contains(bias)
        || !Set.of("none", "filter", "filterexact", "integrator").contains(dynamics)) {
      return Optional.empty();
    }
    List<Double> dynamic = numbers.several(actuator, "dynprm");
    List<Double> gains = numbers.several(actuator, "gainprm");
    List<Double> prm = bias.equals("affine") ? three(actuator, "biasprm") : List.of(0.0, 0.0, 0.0);
    double factor = gains.isEmpty() ? 1 : gains.get(0);
    List<Double> whole = new ArrayList<>(three(actuator, "gainprm"));
    whole.set(0, factor);
    List<Double> taken = gain.equals("affine") ? whole : List.of(factor, 0.0, 0.0);
    // In a servo, whose gain is minus its stiffness, a positive damping is a damping ratio.
    boolean servo = factor == -prm.get(1) && prm.get(2) > 0;
    Law law =
        new Law(
            taken,
            servo ? List.of(prm.get(0), prm.get(1), 0.0) : prm,
            servo ? prm.get(2) : 0,
            Activation.NONE,
            0);
    return Optional.of(
        switch (dynamics) {
          case "filter", "filterexact" -> law.delayed(dynamic.isEmpty() ? 1 : dynamic.get(0));
          case "integrator" -> law.integrated();
          default -> law;
        });
  }

  private List<Double> three(Element actuator, String name) {
    List<Double> all = new ArrayList<>(numbers.several(actuator, name));
    while (all.size() < 3) {
      all.add(0.0);
    }
    return List.copyOf(all.subList(0, 3));
  }
}
