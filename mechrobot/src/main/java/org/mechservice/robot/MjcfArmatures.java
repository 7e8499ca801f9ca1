package org.mechservice.robot;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Joint;

/**
 * The inertias of motors and tendons of an MJCF model, as joints and tendons over joints feel them.
 * A motor counts with the square of its gear. A tendon over one joint is a gear itself; one over
 * several joints moves them together with a rotor, whose angle is its length: that of the mass
 * matrix is then armature · c cᵀ with the factors c of the joints.
 *
 * <p>Source: MuJoCo documentation, XML reference, {@code armature} of {@code tendon} and of {@code
 * actuator}.
 */
final class MjcfArmatures {
  private final RobotNumbers numbers;
  private final ImportLosses losses;
  private final Map<String, Double> joints = new HashMap<>();
  private final Map<String, Double> motorsOfTendons = new HashMap<>();

  /**
   * Reads all motors and tendons.
   *
   * @param scopes the uses of models
   * @param losses receives motors with an inertia that act on something else
   */
  MjcfArmatures(List<MjcfReader.Scope> scopes, RobotNumbers numbers, ImportLosses losses) {
    this.numbers = numbers;
    this.losses = losses;
    Set<Map.Entry<Element, String>> seen = new HashSet<>();
    for (MjcfReader.Scope scope : scopes) {
      Set<String> overJoints = new HashSet<>();
      scope.file().all("tendon").stream()
          .filter(one -> one.name().equals("fixed"))
          .forEach(one -> one.attribute("name").map(scope::named).ifPresent(overJoints::add));
      for (Element actuator : scope.file().all("actuator")) {
        readMotor(scope, actuator, overJoints, seen);
      }
    }
    for (MjcfReader.Scope scope : scopes) {
      for (Element tendon : scope.file().all("tendon")) {
        List<Element> parts = tendon.children("joint");
        if (tendon.name().equals("fixed") && parts.size() == 1) {
          String joint = scope.named(parts.get(0).attribute("joint").orElse(""));
          double factor = numbers.optional(parts.get(0), "coef", 0);
          double along = along(scope, tendon);
          if (along != 0 && seen.add(Map.entry(tendon, joint))) {
            joints.merge(joint, factor * factor * along, Double::sum);
          }
        }
      }
    }
  }

  private void readMotor(
      MjcfReader.Scope scope,
      Element actuator,
      Set<String> overJoints,
      Set<Map.Entry<Element, String>> seen) {
    double armature = numbers.optional(actuator, "armature", 0);
    if (armature == 0) {
      return;
    }
    Optional<String> joint =
        actuator.attribute("joint").or(() -> actuator.attribute("jointinparent")).map(scope::named);
    Optional<String> tendon =
        actuator.attribute("tendon").map(scope::named).filter(overJoints::contains);
    Optional<String> driven = joint.or(() -> tendon);
    if (driven.isEmpty()) {
      losses.motion(
          actuator,
          "its armature is left out: it is read at motors of joints and of tendons over joints");
    } else if (seen.add(Map.entry(actuator, driven.get()))) {
      double gear =
          actuator
              .attribute("gear")
              .map(text -> numbers.read(actuator, "gear", text, 1, 6).get(0))
              .orElse(1.0);
      Map<String, Double> all = joint.isPresent() ? joints : motorsOfTendons;
      all.merge(driven.get(), gear * gear * armature, Double::sum);
    }
  }

  /** Returns a joint with the inertias of its motors and of its own tendons beside its own. */
  Joint armed(Joint joint) {
    double own = joint.coordinate().armature();
    double more = joints.getOrDefault(joint.name(), 0.0);
    return joint.with(joint.coordinate().armed(own + more));
  }

  /**
   * Returns the inertia along a tendon over joints: its own and that of its motors, kg or kg·m² in
   * the unit of its length.
   */
  double along(MjcfReader.Scope scope, Element tendon) {
    double own = numbers.optional(tendon, "armature", 0);
    if (own < 0) {
      numbers.contradiction(tendon, "armature is " + own + "; it must not be negative");
    }
    double motors =
        tendon
            .attribute("name")
            .map(name -> motorsOfTendons.getOrDefault(scope.named(name), 0.0))
            .orElse(0.0);
    return own + motors;
  }
}
