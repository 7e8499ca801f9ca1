package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Names of the kinds of forces in reports. */
public final class ForceKind {
  private ForceKind() {}

  /** Returns name and kind of every force, such as {@code strut (spring between points)}. */
  public static List<String> of(Mechanism mechanism) {
    List<String> kinds = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      kinds.add(force.name() + " (" + kind(force) + ")");
    }
    return kinds;
  }

  private static String kind(ForceElement force) {
    if (force instanceof SpringDamper) {
      return "spring between points";
    }
    if (force instanceof JointSpringDamper) {
      return "spring in a joint";
    }
    if (force instanceof JointFriction) {
      return "friction in a joint";
    }
    if (force instanceof JointForce) {
      return "force in a joint";
    }
    if (force instanceof Bushing) {
      return "bushing";
    }
    if (force instanceof Contact) {
      return "contact";
    }
    if (force instanceof ForceTorque) {
      return "force and torque";
    }
    return "class " + ((UserForceElement) force).className();
  }
}
