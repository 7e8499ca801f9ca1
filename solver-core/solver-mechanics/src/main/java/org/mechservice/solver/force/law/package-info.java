/**
 * Force laws: how large a force is at a given displacement and velocity, with its derivatives and
 * its potential energy.
 *
 * <p>Springs and dampers ({@link org.mechservice.solver.force.law.SpringDamperLaw}, {@link
 * org.mechservice.solver.force.law.JointSpringLaw}), bushings, contacts with friction ({@link
 * org.mechservice.solver.force.law.ContactLaw}), friction in joints and external forces given as
 * formulas. A law knows nothing of the tree: it sees the relative motion of its two frames or one
 * coordinate, and the classes of {@code force.applied} carry the result to the joints.
 *
 * <p>Each law is an energy with a dissipation: the spring part is the gradient of its potential,
 * the damper part never adds energy. Tests compare derivatives with differences and power with the
 * change of energy.
 */
package org.mechservice.solver.force.law;
