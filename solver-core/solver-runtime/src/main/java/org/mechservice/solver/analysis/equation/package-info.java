/**
 * The equations of a mechanism in one state, as analyses and columns of results need them.
 *
 * <p>{@link org.mechservice.solver.analysis.equation.EquationsOfMotion} places the mechanism at a
 * time and a state, applies its forces, and forms residuals, reactions and the solution of least
 * norm. {@link org.mechservice.solver.analysis.equation.FreeDirections} chooses the directions in
 * which the loops let it move. {@link org.mechservice.solver.analysis.equation.Linearisation} gives
 * mass, damping and stiffness about a state in these directions, with {@link
 * org.mechservice.solver.analysis.equation.LoopVariations} for how the directions themselves
 * change. {@link org.mechservice.solver.analysis.equation.Drives} holds what prescribed motions do:
 * their coordinates, forces and power.
 *
 * <p>{@link org.mechservice.solver.analysis.equation.RestingLinks} has mass, damping and stiffness
 * of large mechanisms at rest without forming them.
 *
 * <p>{@link org.mechservice.solver.analysis.equation.FastSpectrum} finds the fastest eigenvalues of
 * any model by differences, for the verdict on stiffness.
 *
 * <p>Everything else is formed from the data of the mechanism. A workspace belongs to one thread.
 *
 * <p>The mathematics is in docs/theory/loops.md#projection and docs/theory/analyses.md.
 */
package org.mechservice.solver.analysis.equation;
