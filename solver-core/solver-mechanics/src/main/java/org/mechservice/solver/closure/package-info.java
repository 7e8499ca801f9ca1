/**
 * Closed loops: the equations Φ(q, t) = 0 of all closures with their derivatives, their rank, the
 * assembly of a start that obeys them, and motion under them by projection (the second velocity
 * transformation) or by penalty (NUMERICS §3).
 */
package org.mechservice.solver.closure;
