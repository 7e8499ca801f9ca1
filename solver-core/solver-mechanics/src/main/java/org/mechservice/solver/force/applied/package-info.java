/**
 * Applied forces in the form that the equations of motion use.
 *
 * <p>An {@link org.mechservice.solver.force.applied.AppliedForce} adds its contribution to the
 * joint forces and wrenches of a state and reports the links that it couples. Two families differ
 * in their points of application: {@link org.mechservice.solver.force.applied.FrameForce} between
 * two frames, with a {@link org.mechservice.solver.force.applied.FrameLaw} of their relative motion
 * ({@link org.mechservice.solver.force.applied.FrameMotion}), and {@link
 * org.mechservice.solver.force.applied.CoordinateForce} along one joint coordinate, with a {@link
 * org.mechservice.solver.force.applied.ScalarLaw}. The laws themselves are in {@code force.law}.
 *
 * <p>Derivatives with respect to positions and velocities go into a {@link
 * org.mechservice.solver.force.applied.ForceJacobian}, which implicit integrators need. Units are
 * SI; a wrench is [moment; force] in link axes at the link's reference point unless a class states
 * otherwise.
 */
package org.mechservice.solver.force.applied;
