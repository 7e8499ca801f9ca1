/**
 * Derivatives of the residual of the equations of motion, for implicit integrators.
 *
 * <p>{@link org.mechservice.solver.dynamics.derivative.ResidualJacobian} gives the derivatives by
 * positions, velocities and accelerations in the tree's sparsity, assembled from the inertia,
 * velocity and force terms. {@link org.mechservice.solver.dynamics.derivative.ResidualDifferences}
 * does the same by differences where a force has no derivative. {@link
 * org.mechservice.solver.dynamics.derivative.TreeIteration} solves the Newton step of an implicit
 * method with both.
 */
package org.mechservice.solver.dynamics.derivative;
