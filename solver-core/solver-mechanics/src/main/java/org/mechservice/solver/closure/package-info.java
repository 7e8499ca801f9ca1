/**
 * Closed loops: motion of a tree under the constraints Φ(q, t) = 0 that its loop closures impose.
 *
 * <p>{@link org.mechservice.solver.closure.ClosedMechanism} is the way in: it joins the description
 * of a mechanism, the closed start and the rank of the constraints, and is shared by all runs.
 * {@link org.mechservice.solver.closure.ClosedTree} is the workspace of one run: tree, loop
 * equations and their solution in one place. The rooms below it:
 *
 * <ul>
 *   <li>{@code closure.equations}: the constraints with their derivatives;
 *   <li>{@code closure.assembly}: rank, redundancy and the closed start;
 *   <li>{@code closure.model}: the models that an integrator sees, by projection or penalty.
 * </ul>
 *
 * <p>Here stand also what the models share: the equations with a penalty ({@link
 * org.mechservice.solver.closure.PenaltyEquations}), projection onto the constraints ({@link
 * org.mechservice.solver.closure.LoopProjection}) and reactions of cut joints. {@link
 * org.mechservice.solver.closure.GeneratedTreeTerms} puts generated code in the place of the
 * data-driven recursions.
 *
 * <p>Up to {@link org.mechservice.solver.closure.equations.LoopEquations#LARGE} velocities matrices
 * are dense, which is fastest there. Beyond, nothing is as large as the square of the mechanism:
 * {@link org.mechservice.solver.closure.ArticulatedLoops} carries the equations of the loops
 * inwards with the articulated bodies, and set-up and choices eliminate in the sparsity of J
 * ({@code closure.assembly}, {@link org.mechservice.solver.closure.model.Partition}).
 *
 * <p>Sources: Rodríguez et al. 2003, section 3; García de Jalón and Bayo 1994, chapters 5 and 6;
 * Popov and Vereshchagin 1978 and Sathya and Carpentier 2024 for the recursion.
 */
package org.mechservice.solver.closure;
