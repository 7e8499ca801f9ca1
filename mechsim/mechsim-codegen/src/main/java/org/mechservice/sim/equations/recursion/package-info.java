/**
 * The sweeps along the tree from which all formulations are made.
 *
 * <p>{@link org.mechservice.sim.equations.recursion.ForceSweep} goes outwards: the motion of each
 * link and the wrench that this motion needs (recursive Newton-Euler). {@link
 * org.mechservice.sim.equations.recursion.JointSweep} goes inwards: what the joints must bear of
 * those wrenches. {@link org.mechservice.sim.equations.recursion.InertiaSweep} forms articulated
 * inertias on the way in, and {@link org.mechservice.sim.equations.recursion.AccelerationSweep}
 * finds the joint accelerations on the way out.
 *
 * <p>{@link org.mechservice.sim.equations.recursion.ArticulatedInertia} and {@link
 * org.mechservice.sim.equations.recursion.RigidComposite} are the inertias carried along, {@link
 * org.mechservice.sim.equations.recursion.ParentTransform} takes them from a link to its parent,
 * {@link org.mechservice.sim.equations.recursion.TreeFactors} factors the mass matrix along the
 * tree, and {@link org.mechservice.sim.equations.recursion.Pivots} lets a program check what it
 * divides by. {@link org.mechservice.sim.equations.recursion.Loads} collects the applied forces
 * that a sweep takes in.
 *
 * <p>Depends on {@code links} and {@code kinematics}. Sources: Featherstone 2008, §5.3, §6.2, §6.5
 * and §7.2; NUMERICS §2.
 */
@NullMarked
package org.mechservice.sim.equations.recursion;

import org.jspecify.annotations.NullMarked;
