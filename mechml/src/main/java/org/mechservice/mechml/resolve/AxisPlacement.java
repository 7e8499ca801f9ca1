package org.mechservice.mechml.resolve;

import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.spatial.Vector3;

/**
 * How a joint about or along one axis sits in its bodies.
 *
 * @param attachment points, and the rotation at zero
 * @param axis unit vector in body1's axes
 */
record AxisPlacement(Attachment attachment, Vector3 axis) {}
