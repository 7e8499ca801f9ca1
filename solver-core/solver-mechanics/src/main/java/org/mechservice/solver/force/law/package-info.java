/**
 * Force laws as formulas: load, potential energy and power of two frames in relative motion or of
 * one coordinate.
 *
 * <p>{@link org.mechservice.solver.force.law.PairLaw} and {@link
 * org.mechservice.solver.force.law.CoordinateLaw} are the catalogue: springs and dampers, bushings,
 * contacts with friction, friction in joints, and laws that are elements of MechML by their {@link
 * org.mechservice.solver.force.law.ForceRow}. A law is written once, over scalars; its coefficients
 * are scalars too. The code of a model derives it with its numbers in place; data run methods that
 * are printed from it ({@code force.law.printed}); all derivatives come from it.
 *
 * <p>A law does not depend on the tree: its arguments are the relative motion of two frames or one
 * coordinate, and the classes of {@code force.applied} apply the result to the links and joints.
 * {@link org.mechservice.solver.force.law.ClosestPoint} searches where a contact touches.
 *
 * <p>Each law is an energy with a dissipation: the spring part is the gradient of its potential,
 * the damper part never adds energy. Tests compare derivatives with differences and power with the
 * change of energy.
 */
package org.mechservice.solver.force.law;
