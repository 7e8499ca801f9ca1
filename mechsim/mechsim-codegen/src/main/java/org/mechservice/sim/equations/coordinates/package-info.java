/**
 * Coordinates of joints of the tree and of cut joints.
 *
 * <p>{@link org.mechservice.sim.equations.coordinates.JointCoordinates} is the main type: it
 * returns the position and velocity of a coordinate to forces, events and couplings, and adds
 * forces along coordinates to the loads. Coordinates of tree joints come from {@link
 * org.mechservice.sim.equations.coordinates.JointLinks}. Coordinates of cut joints follow from the
 * pose of the two bodies that the joint connects: {@link
 * org.mechservice.sim.equations.coordinates.CutCoordinateTerms}, one {@link
 * org.mechservice.sim.equations.coordinates.CutCoordinate} each.
 *
 * <p>{@link org.mechservice.sim.equations.coordinates.RelativeFrameMotion} is the pose and motion
 * of one frame relative to another, {@link org.mechservice.sim.equations.coordinates.PairMotion}
 * the line between two points of different bodies, and {@link
 * org.mechservice.sim.equations.coordinates.PairTerms} are functions of such poses with their first
 * and second derivatives; loop equations use them too.
 *
 * <p>Depends on {@code links}, {@code kinematics} and {@code recursion}. The functions are those of
 * {@link org.mechservice.solver.closure}; docs/theory/loops.md#cutting.
 */
@NullMarked
package org.mechservice.sim.equations.coordinates;

import org.jspecify.annotations.NullMarked;
