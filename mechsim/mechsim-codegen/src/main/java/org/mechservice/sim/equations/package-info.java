/**
 * The mechanics written once over {@link org.mechservice.sim.symbolic.Scalar}: joint accelerations
 * by articulated bodies, energies, poses of the bodies.
 *
 * <p>All recursions run in computing frames: the frame of a {@link
 * org.mechservice.sim.equations.Link} has its origin at the joint's point on the body and its z
 * axis along the joint, so that a joint turns or shifts along one coordinate axis and the terms of
 * the other two stay apart (Featherstone 2008, ch. 7, says what is computed; the frames say how
 * cheaply).
 */
@NullMarked
package org.mechservice.sim.equations;

import org.jspecify.annotations.NullMarked;
