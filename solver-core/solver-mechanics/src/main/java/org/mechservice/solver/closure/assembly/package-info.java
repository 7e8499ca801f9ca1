/**
 * Set-up of closed loops before a run: rank, redundant equations and the closed initial position.
 *
 * <p>{@link org.mechservice.solver.closure.assembly.ClosedStart} is the result, computed once for
 * all who need it. {@link org.mechservice.solver.closure.assembly.Assembly} moves the given
 * position to one that closes all loops by the least change of scaled coordinates, and the
 * velocities likewise; it names a constraint that cannot be closed. {@link
 * org.mechservice.solver.closure.assembly.RankAnalysis} determines the rank of the equations and
 * names each redundant one with its direction. Both use singular values for small mechanisms, and
 * sparse factors for large ones, with singular values for unclear pivots. They report each result
 * as a {@link org.mechservice.solver.closure.assembly.LoopFinding} with its message code. {@link
 * org.mechservice.solver.closure.assembly.LoopDefect} words the defects that end a run.
 */
package org.mechservice.solver.closure.assembly;
