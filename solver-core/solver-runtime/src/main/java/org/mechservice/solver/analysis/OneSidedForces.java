package org.mechservice.solver.analysis;

import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.SpringDamper;

/** Forces that may be zero with their derivatives, such as those of contacts, stops and ropes. */
final class OneSidedForces {
  private OneSidedForces() {}

  /** Returns whether a mechanism has such forces. */
  static boolean in(Mechanism mechanism) {
    return mechanism.forces().stream().anyMatch(OneSidedForces::isOneSided);
  }

  private static boolean isOneSided(ForceElement force) {
    return force instanceof Contact
        || force instanceof PairForce
        || (force instanceof SpringDamper spring && spring.side() != Side.BOTH)
        || (force instanceof JointSpringDamper spring && spring.side() != Side.BOTH)
        || (force instanceof CouplingSpringDamper spring && spring.side() != Side.BOTH);
  }
}
