/**
 * Coordinates of the links, and how links and their points move, as symbolic expressions.
 *
 * <p>{@link org.mechservice.sim.equations.kinematics.Coordinates} is the main type. It names the
 * positions and velocities of one program and gives each link's rotation, with one sine and one
 * cosine per angle. {@link org.mechservice.sim.equations.kinematics.LinkKinematics} computes
 * positions and velocities of links on first use, {@link
 * org.mechservice.sim.equations.kinematics.BodyPoints} gives points and axes of bodies in the
 * computing frames of their links, and {@link
 * org.mechservice.sim.equations.kinematics.JointSubspace} gives the motions S of a link for each of
 * its velocities.
 *
 * <p>{@link org.mechservice.sim.equations.kinematics.PositionRates} writes q' = N(q) v; {@link
 * org.mechservice.sim.equations.kinematics.JointOutputs} writes values of the degrees of freedom in
 * the order of the state. {@link org.mechservice.solver.expression.Formulas} turns formulas of the
 * model file into scalars.
 *
 * <p>Depends on {@code links}. Euler parameters are those of docs/theory/motion.md#positions.
 */
@NullMarked
package org.mechservice.sim.equations.kinematics;

import org.jspecify.annotations.NullMarked;
