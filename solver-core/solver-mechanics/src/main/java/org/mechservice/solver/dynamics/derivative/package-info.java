/**
 * Derivatives of the residual of the equations of motion, for implicit integrators.
 *
 * <p>{@link org.mechservice.solver.dynamics.derivative.ResidualJacobian} evaluates the analytic
 * derivatives of F = M a + b − τ by positions, velocities and accelerations in the tree's sparsity;
 * applied forces add theirs. {@link org.mechservice.solver.dynamics.derivative.ResidualDifferences}
 * computes the same derivatives by difference quotients, for formulations without analytic ones.
 * {@link org.mechservice.solver.dynamics.derivative.TreeIteration} forms the matrix of an implicit
 * step, M + hγ C + hγ² K, from either, factors it along the tree and solves the Newton step.
 *
 * <p>The matrix of a long chain has no zeros. {@link
 * org.mechservice.solver.dynamics.derivative.LinkJacobian} has its derivatives by motions of links,
 * O(n) numbers, and {@link org.mechservice.solver.dynamics.derivative.ArticulatedIteration} solves
 * the step without forming the matrix: link after link, in O(n); with forces between any links and
 * many loops as one sparse system whose graph is the mechanism. {@link
 * org.mechservice.solver.dynamics.derivative.LinksAtRest} keeps mass, damping and stiffness at rest
 * in such a system, symmetric, whose factors tell whether they are positive definite along the
 * loops.
 *
 * <p>Sources: Singh, Russell and Wensing 2022; Carpentier and Mansard 2018.
 */
package org.mechservice.solver.dynamics.derivative;
