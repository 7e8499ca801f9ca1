package org.mechservice.solver.mechanism.force;

/**
 * A visitor with a method for every kind of force. The compiler names every visitor that lacks the
 * method of a new kind.
 *
 * @param <R> type of the answer
 */
public interface ForceVisitor<R> {
  /** Answers for a spring and damper between two points. */
  R springDamper(SpringDamper force);

  /** Answers for a spring and damper in a joint. */
  R jointSpringDamper(JointSpringDamper force);

  /** Answers for a bushing. */
  R bushing(Bushing force);

  /** Answers for a force and torque given by expressions. */
  R forceTorque(ForceTorque force);

  /** Answers for a force in a joint given by an expression. */
  R jointForce(JointForce force);

  /** Answers for a spring and damper along a coupling. */
  R couplingSpringDamper(CouplingSpringDamper force);

  /** Answers for a tension along a path. */
  R pathForce(PathForce force);

  /** Answers for a contact. */
  R contact(Contact force);

  /** Answers for a force between two frames given by formulas. */
  R pairForce(PairForce force);

  /** Answers for a law of the catalogue between two frames. */
  R lawForce(LawForce force);

  /** Answers for friction in a joint. */
  R jointFriction(JointFriction force);

  /** Answers for a force that is a user's class. */
  R userForce(UserForceElement force);
}
