/**
 * Set-up of closed loops before a run: rank, redundant equations and the closed initial position.
 *
 * <p>{@link org.mechservice.solver.closure.assembly.ClosedStart} is the result, found once for all
 * who need it. {@link org.mechservice.solver.closure.assembly.Assembly} moves the least, in the
 * sense of scaled coordinates, from the position given to one that closes all loops, and the
 * velocities likewise; it names the constraint that cannot be closed. {@link
 * org.mechservice.solver.closure.assembly.RankAnalysis} finds how many equations are independent
 * and which follow from the others, each by name and direction. Both are strategies: by singular
 * values, or, for large mechanisms, by sparse factors with singular values for what is in doubt.
 * What they find is a {@link org.mechservice.solver.closure.assembly.LoopFinding}, with its message
 * code.
 */
package org.mechservice.solver.closure.assembly;
