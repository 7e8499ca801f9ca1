/**
 * The recursions over a tree of bodies from which all formulations are built.
 *
 * <ul>
 *   <li>{@link org.mechservice.solver.dynamics.recursion.NewtonEuler}: inverse dynamics, outward
 *       for velocities and accelerations, inward for forces.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.CompositeInertias}: the mass matrix.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.TreeSteps}: accelerations of an open tree
 *       in O(n), and the forces for given ones, by printed steps.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.TreeElimination}: the same elimination of
 *       joints link by link, for trees with the equations of loops.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.MassiveRods}: rods with mass between two
 *       bodies, which belong to no joint.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.LinkDerivatives}: derivatives of the
 *       Newton-Euler recursion.
 *   <li>{@link org.mechservice.solver.dynamics.recursion.JointReactions} and {@link
 *       org.mechservice.solver.dynamics.recursion.TotalMomentum}: results, at output times only.
 * </ul>
 *
 * <p>Spatial vectors of a link are in link axes at the link's reference point, so that results keep
 * their digits far from the world's origin. Nothing allocates after construction. Sources:
 * Featherstone 2008, chapters 5 to 7; Rodríguez et al. 2003, section 3.
 */
package org.mechservice.solver.dynamics.recursion;
