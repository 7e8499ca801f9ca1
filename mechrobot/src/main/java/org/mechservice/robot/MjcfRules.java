package org.mechservice.robot;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.document.Element;

/**
 * What MuJoCo refuses in single elements, whatever the rest of the file says. Such files are
 * refused here, too: what they mean is not defined.
 *
 * <p>Source: MuJoCo documentation, XML reference, and what its compiler of version 4.0 says.
 */
final class MjcfRules {
  /** Attributes of which an element may write only one, by element; classes are not counted. */
  private static final Map<String, List<List<String>>> EITHER =
      Map.of(
          "position", List.of(List.of("kv", "dampratio")),
          "intvelocity", List.of(List.of("kv", "dampratio")),
          "inertial", List.of(List.of("diaginertia", "fullinertia")));

  /** What a servo sets by the range of its joint, so that it may not write that itself. */
  private static final Map<String, String> INHERITED =
      Map.of("position", "ctrlrange", "intvelocity", "actrange");

  /** Attributes with whole numbers, by element. */
  private static final Map<String, List<String>> WHOLE =
      Map.of(
          "geom", List.of("group", "condim", "contype", "conaffinity", "priority"),
          "site", List.of("group"),
          "joint", List.of("group"),
          "compiler", List.of("inertiagrouprange"),
          "mesh", List.of("face"));

  /** Ranges and the attributes that say whether they hold. */
  private static final Map<String, String> LIMITED =
      Map.of(
          "range", "limited",
          "actuatorfrcrange", "actuatorfrclimited",
          "ctrlrange", "ctrllimited",
          "forcerange", "forcelimited",
          "actrange", "actlimited");

  private static final Set<String> MOTORS =
      Set.of(
          "general",
          "motor",
          "position",
          "velocity",
          "intvelocity",
          "damper",
          "cylinder",
          "muscle");

  private static final Set<String> WITH_ENDS = Set.of("capsule", "cylinder", "box", "ellipsoid");

  private final RobotNumbers numbers;

  /**
   * @param numbers reports what is refused
   */
  MjcfRules(RobotNumbers numbers) {
    this.numbers = numbers;
  }

  /**
   * Checks elements as their file writes them.
   *
   * @param whole the file with what it includes, before default classes are put in
   */
  void checkWritten(Element whole) {
    for (Element child : whole.children()) {
      for (List<String> names : EITHER.getOrDefault(child.name(), List.of())) {
        if (names.stream().allMatch(name -> child.attribute(name).isPresent())) {
          numbers.contradiction(
              child, "it has " + String.join(" and ", names) + "; leave one of them out");
        }
      }
      String inherited = INHERITED.getOrDefault(child.name(), "");
      if (child.attribute(inherited).isPresent()
          && numbers.optional(child, "inheritrange", 0) > 0) {
        numbers.contradiction(
            child, "it has inheritrange and " + inherited + "; leave one of them out");
      }
      for (String name : WHOLE.getOrDefault(child.name(), List.of())) {
        child.attribute(name).ifPresent(text -> checkWhole(child, name, text));
      }
      checkWritten(child);
    }
  }

  private void checkWhole(Element element, String name, String text) {
    for (String word : text.strip().split("\\s+", -1)) {
      if (!word.isEmpty() && !word.matches("[-+]?\\d+")) {
        numbers.contradiction(element, name + " has the number " + word + ", and takes whole ones");
        return;
      }
    }
  }

  /**
   * Checks elements with the values of their default classes.
   *
   * @param root of the file
   * @param autolimits whether a range holds by being there
   */
  void checkComplete(Element root, boolean autolimits) {
    for (Element section : root.children()) {
      switch (section.name()) {
        case "worldbody" -> checkBody(section, autolimits);
        case "tendon" -> section.children().forEach(one -> checkTendon(one, autolimits));
        case "actuator" -> section.children().forEach(one -> checkMotor(one, autolimits));
        default -> {
          // The other sections have no limits.
        }
      }
    }
  }

  private void checkBody(Element body, boolean autolimits) {
    for (Element part : body.children()) {
      switch (part.name()) {
        case "joint" -> checkJoint(part, autolimits);
        case "geom" -> checkShape(part);
        case "body", "frame", "replicate" -> checkBody(part, autolimits);
        default -> {
          // Other parts have no limits and no mass.
        }
      }
    }
  }

  private void checkJoint(Element joint, boolean autolimits) {
    checkSaid(joint, "range", autolimits);
    checkSaid(joint, "actuatorfrcrange", autolimits);
    boolean ball = joint.attribute("type").filter("ball"::equals).isPresent();
    boolean limited =
        joint.attribute("limited").filter("true"::equals).isPresent()
            || (autolimits && joint.attribute("limited").filter("false"::equals).isEmpty());
    if (ball && limited && range(joint, "range").filter(ends -> ends.get(0) != 0).isPresent()) {
      numbers.contradiction(
          joint, "its range is that of an angle between two frames; write 0 as its lower end");
    }
    if (joint.attribute("type").filter("free"::equals).isPresent()
        && numbers.optional(joint, "springyield", 0) != 0) {
      numbers.contradiction(joint, "a free joint has no springyield; leave it out");
    }
  }

  private void checkShape(Element shape) {
    boolean mesh = shape.attribute("mesh").isPresent();
    String type = shape.attribute("type").orElse("sphere");
    if (mesh
        && type.equals("mesh")
        && shape.attribute("shellinertia").filter("true"::equals).isPresent()) {
      numbers.contradiction(
          shape, "shellinertia is not for meshes; write inertia=\"shell\" at the mesh");
    }
    if (shape.attribute("fromto").isPresent() && !WITH_ENDS.contains(type)) {
      numbers.contradiction(shape, "a " + type + " has no two ends (fromto)");
    }
  }

  private void checkTendon(Element tendon, boolean autolimits) {
    checkSaid(tendon, "range", autolimits);
    requireRange(tendon, "range");
    boolean around = !tendon.children("geom").isEmpty();
    if (around && numbers.optional(tendon, "armature", 0) != 0) {
      numbers.contradiction(
          tendon, "it has an armature and goes around shapes; MuJoCo has no inertia of such ones");
    }
  }

  private void checkMotor(Element motor, boolean autolimits) {
    if (!MOTORS.contains(motor.name())) {
      return;
    }
    checkSaid(motor, "ctrlrange", autolimits);
    checkSaid(motor, "forcerange", autolimits);
    requireRange(motor, "forcerange");
    if (!(numbers.optional(motor, "inheritrange", 0) > 0)) {
      requireRange(motor, "ctrlrange");
    }
    if (motor.name().equals("damper")
        && range(motor, "ctrlrange").filter(MjcfRules::isRange).isEmpty()) {
      numbers.contradiction(motor, "a damper needs a ctrlrange, and it is missing or empty");
    }
    checkSaid(motor, "actrange", autolimits);
    if (motor.name().equals("general")) {
      requireRange(motor, "actrange");
      checkActivation(motor);
    }
    if (numbers.optional(motor, "delay", 0) > 0 && !(numbers.optional(motor, "nsample", 0) > 0)) {
      numbers.contradiction(motor, "its delay needs nsample, the size of its history");
    }
  }

  private void checkActivation(Element general) {
    boolean still = general.attribute("dyntype").orElse("none").equals("none");
    boolean limited = general.attribute("actlimited").filter("false"::equals).isEmpty();
    if (still && limited && range(general, "actrange").filter(MjcfRules::isRange).isPresent()) {
      numbers.contradiction(
          general,
          "it has an actrange and no activation; write its dyntype, or leave actrange out");
    }
  }

  /** With autolimits off, a range without a word on whether it holds is refused. */
  private void checkSaid(Element element, String range, boolean autolimits) {
    String limited = LIMITED.getOrDefault(range, "");
    boolean said = element.attribute(limited).filter(word -> !word.equals("auto")).isPresent();
    boolean given =
        range(element, range).filter(ends -> ends.stream().anyMatch(end -> end != 0)).isPresent();
    if (!autolimits && given && !said) {
      numbers.contradiction(
          element,
          "it has " + range + " and autolimits is off; write whether it holds: " + limited);
    }
  }

  private void requireRange(Element element, String range) {
    String limited = LIMITED.getOrDefault(range, "");
    if (element.attribute(limited).filter("true"::equals).isPresent()
        && range(element, range).filter(MjcfRules::isRange).isEmpty()) {
      numbers.contradiction(
          element, limited + " is true, and " + range + " is missing or empty; write it");
    }
  }

  private static boolean isRange(List<Double> ends) {
    return ends.get(0) < ends.get(1);
  }

  private Optional<List<Double>> range(Element element, String name) {
    return element.attribute(name).map(text -> numbers.read(element, name, text, 2, 2));
  }
}
