package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.MjcfForces.Tendon;
import org.mechservice.robot.Robot.Filter;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Input;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.JointForce;

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
  private static final Set<String> READ =
      Set.of("motor", "position", "velocity", "damper", "general");

  /** Force on a joint from all its motors. */
  private record Sum(Element element, List<String> parts) {}

  /**
   * The force of an actuator: its factor of the input, and a₀ + a₁ length + a₂ velocity.
   *
   * @param dampingRatio from which MuJoCo makes a₂; 0 if that is given
   * @param time time constant with which the input acts, s; 0 if it acts at once
   */
  private record Law(double gain, List<Double> bias, double dampingRatio, double time) {
    Law(double gain, List<Double> bias) {
      this(gain, bias, 0, 0);
    }

    /** Returns the law with the damping for an inertia as the actuator sees it. */
    Law damped(double inertia) {
      double damping = 2 * dampingRatio * Math.sqrt(-bias.get(1) * inertia);
      return new Law(gain, List.of(bias.get(0), bias.get(1), -damping), 0, time);
    }

    boolean actsAlone() {
      return bias.stream().anyMatch(x -> x != 0);
    }
  }

  private final Map<String, Joint> joints;
  private final Map<String, Double> references;
  private final RobotInertia inertia;
  private final RobotNumbers numbers;
  private final ImportLosses losses;
  private final List<Force> inputs = new ArrayList<>();
  private final Map<String, Sum> sums = new LinkedHashMap<>();
  private final Set<String> names = new HashSet<>();

  MjcfActuators(
      Map<String, Joint> joints,
      Map<String, Double> references,
      RobotInertia inertia,
      RobotNumbers numbers,
      ImportLosses losses) {
    this.joints = joints;
    this.references = references;
    this.inertia = inertia;
    this.numbers = numbers;
    this.losses = losses;
  }

  /** Returns the inputs, then the forces. */
  List<Force> forces() {
    List<Force> all = new ArrayList<>(inputs);
    sums.forEach(
        (name, sum) -> {
          String force = String.join(" + ", sum.parts());
          Element joint = joint(name).element();
          Optional<String> range = joint.attribute("actuatorfrcrange");
          boolean limited =
              range.isPresent()
                  && !joint.attribute("actuatorfrclimited").orElse("auto").equals("false");
          if (limited) {
            force = clamped(force, numbers.read(joint, "actuatorfrcrange", range.get(), 2, 2));
          }
          all.add(new JointForce(sum.element(), name + " motor", name, force));
        });
    return all;
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
    Optional<Law> law = law(actuator);
    if (law.isEmpty()) {
      lose(actuator, true, "a motor of this kind is left out");
      return;
    }
    List<Double> gear =
        actuator
            .attribute("gear")
            .map(text -> numbers.read(actuator, "gear", text, 1, 6))
            .orElse(List.of(1.0));
    Map<String, Double> moments = new LinkedHashMap<>();
    Optional<String> single = actuator.attribute("joint");
    Optional<Tendon> tendon =
        actuator
            .attribute("tendon")
            .flatMap(name -> Optional.ofNullable(tendons.get(scope.named(name))));
    if (single.isPresent()) {
      Joint joint = joints.get(scope.named(single.get()));
      if (joint == null) {
        numbers.contradiction(actuator, "joint \"" + single.get() + "\" does not exist");
        return;
      }
      if (joint.type().isSingle()) {
        moments.put(joint.name(), gear.get(0));
      }
    } else if (tendon.isPresent()) {
      tendon.get().terms().forEach((joint, factor) -> moments.put(joint, gear.get(0) * factor));
    }
    if (moments.isEmpty()) {
      lose(
          actuator,
          law.get().actsAlone(),
          "it is left out: only motors of hinges, slides and fixed tendons are read");
      return;
    }
    Law acting = law.get();
    if (acting.dampingRatio() != 0 && single.isPresent()) {
      double factor = gear.get(0);
      acting = acting.damped(inertia.free(scope.named(single.get())) / (factor * factor));
    } else if (acting.dampingRatio() != 0) {
      losses.motion(actuator, "its damping ratio is left out: it is read at single joints");
    }
    boolean turns =
        moments.keySet().stream().allMatch(name -> joint(name).type() != Freedom.PRISMATIC);
    addForces(actuator, scope, acting, moments, turns);
  }

  private void lose(Element actuator, boolean alone, String what) {
    losses.add(alone ? LossGrade.MOTION : LossGrade.CONTACT, actuator, what);
  }

  private void addForces(
      Element actuator,
      MjcfReader.Scope scope,
      Law law,
      Map<String, Double> moments,
      boolean turns) {
    String first = moments.keySet().iterator().next();
    String name =
        actuator.attribute("name").map(scope::named).orElse(first + " " + actuator.name());
    while (!names.add(name)) {
      name += "_";
    }
    boolean commands = actuator.name().equals("position") || actuator.name().equals("velocity");
    String unit = commands ? (turns ? "rad" : "m") : turns ? "N*m" : "N";
    unit = actuator.name().equals("velocity") ? unit + "/s" : unit;
    String signal = actuator.name().matches("general|damper") ? "1" : unit;
    inputs.add(new Input(actuator, name, signal));
    String u = MechmlText.name(name);
    Optional<List<Double>> control = range(actuator, "ctrl");
    if (control.isPresent()) {
      u = clamped(u, control.get());
    }
    if (law.time() > 0) {
      String follower = name + " activation";
      while (!names.add(follower)) {
        follower += "_";
      }
      inputs.add(new Filter(actuator, follower, signal, u, law.time()));
      u = MechmlText.name(follower);
    }
    double offset = 0;
    for (Map.Entry<String, Double> moment : moments.entrySet()) {
      offset += moment.getValue() * references.getOrDefault(moment.getKey(), 0.0);
    }
    StringBuilder force = new StringBuilder();
    if (actuator.name().equals("damper")) {
      // -kv · velocity · u
      force.append("-(").append(MechmlText.number(law.gain())).append(")*");
      force.append("(").append(MechmlText.sum(moments, ".v")).append(")*").append(u);
    } else {
      force.append("(").append(MechmlText.number(law.gain())).append(")*").append(u);
      List<Double> bias = law.bias();
      double constant = bias.get(0) + bias.get(1) * offset;
      if (constant != 0) {
        force.append(" + (").append(MechmlText.number(constant)).append(")");
      }
      for (int i = 1; i < 3; i++) {
        if (bias.get(i) != 0) {
          force.append(" + (").append(MechmlText.number(bias.get(i))).append(")*(");
          force.append(MechmlText.sum(moments, i == 1 ? ".q" : ".v")).append(")");
        }
      }
    }
    Optional<List<Double>> limits = range(actuator, "force");
    String whole = limits.map(r -> clamped(force.toString(), r)).orElse("(" + force + ")");
    moments.forEach(
        (joint, factor) ->
            sums.computeIfAbsent(joint, key -> new Sum(actuator, new ArrayList<>()))
                .parts()
                .add(factor == 1 ? whole : "(" + MechmlText.number(factor) + ")*" + whole));
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
    switch (actuator.name()) {
      case "motor" -> {
        return Optional.of(new Law(1, none));
      }
      case "position" -> {
        double kp = numbers.optional(actuator, "kp", 1);
        double kv = numbers.optional(actuator, "kv", 0);
        double ratio = numbers.optional(actuator, "dampratio", 0);
        double time = numbers.optional(actuator, "timeconst", 0);
        return Optional.of(new Law(kp, List.of(0.0, -kp, -kv), ratio, time));
      }
      case "velocity" -> {
        double kv = numbers.optional(actuator, "kv", 1);
        return Optional.of(new Law(kv, List.of(0.0, 0.0, -kv)));
      }
      case "damper" -> {
        return Optional.of(new Law(numbers.optional(actuator, "kv", 1), none));
      }
      default -> {
        return general(actuator);
      }
    }
  }

  private Optional<Law> general(Element actuator) {
    String gain = actuator.attribute("gaintype").orElse("fixed");
    String bias = actuator.attribute("biastype").orElse("none");
    String dynamics = actuator.attribute("dyntype").orElse("none");
    boolean filtered = dynamics.equals("filter") || dynamics.equals("filterexact");
    if (!gain.equals("fixed")
        || !Set.of("none", "affine").contains(bias)
        || !(filtered || dynamics.equals("none"))) {
      return Optional.empty();
    }
    List<Double> dynamic = list(actuator, "dynprm");
    double time = filtered ? (dynamic.isEmpty() ? 1 : dynamic.get(0)) : 0;
    List<Double> prm = new ArrayList<>(list(actuator, "biasprm"));
    while (prm.size() < 3) {
      prm.add(0.0);
    }
    List<Double> gains = list(actuator, "gainprm");
    double factor = gains.isEmpty() ? 1 : gains.get(0);
    if (!bias.equals("affine")) {
      return Optional.of(new Law(factor, List.of(0.0, 0.0, 0.0), 0, time));
    }
    // In a servo, whose gain is minus its stiffness, a positive damping is a damping ratio.
    boolean servo = factor == -prm.get(1) && prm.get(2) > 0;
    return Optional.of(
        servo
            ? new Law(factor, List.of(prm.get(0), prm.get(1), 0.0), prm.get(2), time)
            : new Law(factor, prm.subList(0, 3), 0, time));
  }

  private List<Double> list(Element actuator, String name) {
    return actuator
        .attribute(name)
        .map(text -> numbers.read(actuator, name, text, 0, 20))
        .orElse(List.of());
  }
}
