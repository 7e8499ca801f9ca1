/**
 * The sweeps along the tree from which all formulations are built.
 *
 * <p>{@link org.mechservice.sim.equations.recursion.ForceSweep} goes outwards: the motion of each
 * link and its inertia wrench (recursive Newton-Euler). {@link
 * org.mechservice.sim.equations.recursion.JointSweep} goes inwards: the joint forces for those
 * wrenches. {@link org.mechservice.sim.equations.recursion.InertiaSweep} goes inwards and forms
 * articulated inertias, and {@link org.mechservice.sim.equations.recursion.AccelerationSweep} goes
 * outwards and computes the joint accelerations.
 *
 * <p>{@link org.mechservice.solver.step.ArticulatedInertia} and {@link
 * org.mechservice.sim.equations.recursion.RigidComposite} are the two kinds of inertia, {@link
 * org.mechservice.sim.equations.recursion.ParentTransform} transforms them from a link to its
 * parent, {@link org.mechservice.sim.equations.recursion.TreeFactors} factors the mass matrix along
 * the tree, and {@link org.mechservice.sim.equations.recursion.Pivots} adds checks of divisors to a
 * program. {@link org.mechservice.sim.equations.recursion.Loads} collects the applied forces that a
 * sweep reads.
 *
 * <p>Depends on {@code links} and {@code kinematics}. Sources: Featherstone 2008, §5.3, §6.2, §6.5
 * and §7.2; docs/theory/formulations.md.
 */
@NullMarked
package org.mechservice.sim.equations.recursion;

import org.jspecify.annotations.NullMarked;
