package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** Names of the velocities of the state and of their coordinates. */
final class CoordinateNames {
  private final List<String> names = new ArrayList<>();
  private final List<Boolean> slides = new ArrayList<>();

  /** Whether the joint has several velocities. */
  private final List<Boolean> several = new ArrayList<>();

  CoordinateNames(Mechanism mechanism) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      JointType type = joint.type();
      for (int i = 0; i < type.velocityCount() && !mechanism.isDriven(j); i++) {
        names.add(type.velocityCount() == 1 ? joint.name() : joint.name() + "[" + i + "]");
        several.add(type.velocityCount() > 1);
        slides.add(type.velocityUnit(i).startsWith("m"));
      }
    }
  }

  /** Returns the joint's name, with the number of the velocity if the joint has several. */
  String name(int velocity) {
    return names.get(velocity);
  }

  /** Returns the name of a quantity of the coordinate: {@code hinge.q}, {@code ball.v[2]}. */
  String of(int velocity, String quantity) {
    String name = names.get(velocity);
    int bracket = several.get(velocity) ? name.lastIndexOf('[') : name.length();
    return name.substring(0, bracket) + "." + quantity + name.substring(bracket);
  }

  /** Returns the coordinate for messages. */
  String part(int velocity) {
    return "coordinate \"" + name(velocity) + "\"";
  }

  /** Returns the unit of a small move: m or rad. */
  String unit(int velocity) {
    return slides.get(velocity) ? "m" : "rad";
  }

  int count() {
    return names.size();
  }
}
