package org.mechservice.sim.equations.loop;

import java.util.Optional;
import org.mechservice.sim.symbolic.Scalar;

/**
 * An equation of a loop, Φ = 0, with what a closure needs of it.
 *
 * @param value Φ, m or rad
 * @param rate Φ'
 * @param offset γ: Φ'' while no joint accelerates but the driven ones
 * @param jacobian by the velocities of the state, in their order
 * @param size the size of what it measures where that changes, m or 1 rad
 */
@SuppressWarnings("ArrayRecordComponent") // made once, read once
record LoopRow(
    Scalar value, Scalar rate, Scalar offset, Scalar[] jacobian, Optional<Scalar> size) {}
