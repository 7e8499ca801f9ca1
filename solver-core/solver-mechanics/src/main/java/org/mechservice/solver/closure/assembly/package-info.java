/**
 * Set-up of closed loops before a run: rank, redundant equations and the closed initial position.
 *
 * <p>{@link org.mechservice.solver.closure.assembly.ClosedStart} is the result, computed once for
 * all who need it. {@link org.mechservice.solver.closure.assembly.Assembly} chooses what may move,
 * {@link org.mechservice.solver.closure.assembly.NearestPositions} finds the nearest positions that
 * close all loops, at starts and after events alike, and velocities change by the least amount; a
 * constraint that cannot be closed is named. {@link
 * org.mechservice.solver.closure.assembly.RankAnalysis} determines the rank of the equations and
 * names each redundant one with its direction. Both use singular values for small mechanisms, and
 * sparse factors for large ones, with singular values for unclear pivots. They report each result
 * as a {@link org.mechservice.solver.closure.assembly.LoopFinding} with its message code. {@link
 * org.mechservice.solver.closure.assembly.LoopDefect} words the defects that end a run.
 */
package org.mechservice.solver.closure.assembly;
