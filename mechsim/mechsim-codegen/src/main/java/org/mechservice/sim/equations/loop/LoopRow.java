package org.mechservice.sim.equations.loop;

import java.util.Optional;
import org.mechservice.solver.symbol.Scalar;

/**
 * An equation of a loop, Φ = 0, with the quantities that a closure needs.
 *
 * @param value Φ, m or rad
 * @param rate Φ'
 * @param offset γ: Φ'' with zero accelerations of all joints that are not driven
 * @param jacobian derivatives by the velocities of the state, in their order
 * @param size the size of the measured quantity if it changes, m or 1 rad
 */
@SuppressWarnings("ArrayRecordComponent") // made once, read once
record LoopRow(
    Scalar value, Scalar rate, Scalar offset, Scalar[] jacobian, Optional<Scalar> size) {}
