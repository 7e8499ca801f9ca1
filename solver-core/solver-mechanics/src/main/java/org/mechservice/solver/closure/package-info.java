/**
 * Closed loops: motion of a tree under the constraints Φ(q, t) = 0 that its loop closures impose.
 *
 * <p>{@link org.mechservice.solver.closure.ClosedMechanism} is the entry point: it joins the
 * description of a mechanism, its assembled start and the rank of its constraints, and all runs
 * share it. {@link org.mechservice.solver.closure.ClosedTree} is the workspace of one run: tree,
 * loop equations and their solution. The packages below it:
 *
 * <ul>
 *   <li>{@code closure.equations}: the constraints with their derivatives;
 *   <li>{@code closure.assembly}: rank, redundancy and the closed start;
 *   <li>{@code closure.model}: the models that an integrator sees, by projection or penalty.
 * </ul>
 *
 * <p>This package also holds what the models share: the equations with a penalty ({@link
 * org.mechservice.solver.closure.PenaltyEquations}), projection onto the constraints ({@link
 * org.mechservice.solver.closure.LoopProjection}) and reactions of cut joints. {@link
 * org.mechservice.solver.closure.GeneratedTreeTerms} replaces the data-driven recursions by
 * generated code.
 *
 * <p>Up to {@link org.mechservice.solver.closure.equations.LoopEquations#LARGE} velocities matrices
 * are dense and have code of their own. Larger mechanisms use sparse algorithms: {@link
 * org.mechservice.solver.closure.ArticulatedLoops} carries the loop equations inwards with the
 * articulated bodies, and assembly and the choice of coordinates eliminate in the sparsity of J
 * ({@code closure.assembly}, {@link org.mechservice.solver.closure.model.Partition}).
 *
 * <p>Sources: Rodríguez et al. 2003, section 3; García de Jalón and Bayo 1994, chapters 5 and 6;
 * Popov and Vereshchagin 1978 and Sathya and Carpentier 2024 for the recursion.
 */
package org.mechservice.solver.closure;
