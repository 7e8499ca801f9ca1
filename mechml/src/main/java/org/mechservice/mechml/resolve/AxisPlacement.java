package org.mechservice.mechml.resolve;

import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.spatial.Vector3;

/**
 * How a joint sits in its bodies.
 *
 * @param attachment points, and the rotation at zero
 * @param axis1 unit vector in body1's axes; zero for a joint without axes
 * @param axis2 unit vector in body2's axes; zero for a joint without axes
 */
record AxisPlacement(Attachment attachment, Vector3 axis1, Vector3 axis2) {}
