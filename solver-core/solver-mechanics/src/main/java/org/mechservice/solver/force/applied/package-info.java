/**
 * Applied forces in the form in which the equations of motion take them.
 *
 * <p>An {@link org.mechservice.solver.force.applied.AppliedForce} adds its share to the joint
 * forces and wrenches of a state and says which states it couples. There are two families, by the
 * place at which they act: {@link org.mechservice.solver.force.applied.FrameForce} between two
 * frames, with a {@link org.mechservice.solver.force.applied.FrameLaw} of their relative motion
 * ({@link org.mechservice.solver.force.applied.FrameMotion}), and {@link
 * org.mechservice.solver.force.applied.CoordinateForce} along one joint coordinate, with a {@link
 * org.mechservice.solver.force.applied.ScalarLaw}. The laws themselves stand in {@code force.law}.
 *
 * <p>Derivatives with respect to positions and velocities go into a {@link
 * org.mechservice.solver.force.applied.ForceJacobian}, which an implicit integrator reads. Units
 * are SI; wrenches are in world axes about the world origin unless a class says otherwise.
 */
package org.mechservice.solver.force.applied;
