package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Vector3;

/**
 * Two vectors, one fixed in each body, whose product β = x · R y depends on their relative
 * orientation.
 *
 * @param inA x in A's axes
 * @param inB y in B's axes
 */
public record AxisPair(Vector3 inA, Vector3 inB) {}
