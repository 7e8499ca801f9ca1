package org.mechservice.robot;

import java.util.Optional;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;

/** A coordinate of the mechanism that is a joint of MuJoCo, with what MJCF has along it. */
final class MjcfCoordinate {
  /** Further than any position, rad or m: MuJoCo's ranges have two ends. */
  private static final double FAR = 1e6;

  private final String name;
  private double stiffness;
  private double moment;
  private double damping;
  private double friction;
  private double armature;
  private Optional<Double> lower = Optional.empty();
  private Optional<Double> upper = Optional.empty();
  private double stopTime;

  /**
   * @param name of the joint in MJCF
   */
  MjcfCoordinate(String name) {
    this.name = name;
  }

  String name() {
    return name;
  }

  /** Adds inertia of a motor, kg or kg·m². */
  void arm(double more) {
    armature += more;
  }

  /** Takes a spring or stop of the joint; returns whether MJCF has it. */
  boolean take(JointSpringDamper spring, Mechanism mechanism, ExportLosses losses) {
    Optional<Double> k = LinearRelation.number(spring.stiffness(), mechanism);
    Optional<Double> c = LinearRelation.number(spring.damping(), mechanism);
    Optional<Double> at = LinearRelation.number(spring.position0(), mechanism);
    Optional<Double> force = LinearRelation.number(spring.force0(), mechanism);
    if (k.isEmpty() || c.isEmpty() || at.isEmpty() || force.isEmpty()) {
      return false;
    }
    if (spring.side() == Side.BOTH) {
      if (force.get() != 0 && stiffness + k.get() == 0) {
        return false;
      }
      stiffness += k.get();
      moment += k.get() * at.get() + force.get();
      damping += c.get();
      return true;
    }
    boolean above = spring.side() == Side.ABOVE;
    if ((above ? upper : lower).isPresent()) {
      return false;
    }
    if (above) {
      upper = at;
    } else {
      lower = at;
    }
    // A stop of the damping ratio 1 has the time constant c / (2 k).
    double time = c.get() / (2 * k.get());
    boolean other = stopTime != 0 && Math.abs(time - stopTime) > 1e-9 * stopTime;
    if (!(time > 0)
        || other
        || LinearRelation.number(spring.smoothing(), mechanism).orElse(1.0) != 0) {
      losses.add(
          spring.origin(),
          "stiffness, damping and smoothing of \""
              + spring.name()
              + "\" are left out: a limit of MJCF has a time constant");
    } else {
      stopTime = time;
      // the ratio would take the inertia that the stop holds
      losses.add(
          spring.origin(),
          "\""
              + spring.name()
              + "\" is a limit of MJCF, with the time constant of its damping and stiffness and the"
              + " damping ratio 1");
    }
    return true;
  }

  /** Takes the friction of the joint; returns whether MJCF has it. */
  boolean take(JointFriction given, Mechanism mechanism, ExportLosses losses) {
    Optional<Double> coulomb = LinearRelation.number(given.coulomb(), mechanism);
    Optional<Double> viscous = LinearRelation.number(given.viscous(), mechanism);
    if (coulomb.isEmpty() || viscous.isEmpty() || (friction != 0 && coulomb.get() != 0)) {
      return false;
    }
    friction += coulomb.get();
    damping += viscous.get();
    if (coulomb.get() != 0) {
      losses.add(
          given.origin(),
          "the transition speed of \"" + given.name() + "\" is left out: MuJoCo has its own");
    }
    return true;
  }

  /** Adds all of it to the element of the joint. */
  void addTo(TagBuilder joint) {
    if (stiffness != 0) {
      joint.set("stiffness", stiffness).set("springref", moment / stiffness);
    }
    if (damping != 0) {
      joint.set("damping", damping);
    }
    if (friction != 0) {
      joint.set("frictionloss", friction);
    }
    if (armature != 0) {
      joint.set("armature", armature);
    }
    if (lower.isPresent() || upper.isPresent()) {
      joint.set(
          "range",
          MechmlText.number(lower.orElse(-FAR)) + " " + MechmlText.number(upper.orElse(FAR)));
      if (stopTime > 0) {
        joint.set("solreflimit", MechmlText.number(stopTime) + " 1");
      }
    }
  }
}
