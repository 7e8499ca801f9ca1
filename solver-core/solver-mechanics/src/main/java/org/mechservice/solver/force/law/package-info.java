/**
 * Force laws: the force at a given displacement and velocity, with its derivatives and its
 * potential energy.
 *
 * <p>The laws are springs and dampers ({@link org.mechservice.solver.force.law.SpringDamperLaw},
 * {@link org.mechservice.solver.force.law.JointSpringLaw}), bushings, contacts with friction
 * ({@link org.mechservice.solver.force.law.ContactLaw}), friction in joints, and forces set from
 * outside. A law does not depend on the tree: its arguments are the relative motion of two frames
 * or one coordinate, and the classes of {@code force.applied} apply the result to the links and
 * joints.
 *
 * <p>Each law is an energy with a dissipation: the spring part is the gradient of its potential,
 * the damper part never adds energy. Tests compare derivatives with differences and power with the
 * change of energy.
 */
package org.mechservice.solver.force.law;
