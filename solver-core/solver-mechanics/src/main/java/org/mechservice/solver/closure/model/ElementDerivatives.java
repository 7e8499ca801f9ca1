package org.mechservice.solver.closure.model;

import java.util.Optional;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.dynamics.derivative.ResidualDifferences;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.tree.TreePattern;

/**
 * The derivatives of the open tree's residual element by element, and the matrix of an implicit
 * step that is formed of them.
 *
 * @param pattern pairs of velocities with an element
 * @param jacobian ∂F/∂q, ∂F/∂v and ∂F/∂v'
 * @param iteration M + hγ C + hγ² K
 * @param differences evaluates the elements of RR; empty for RR-JF, which evaluates them by
 *     recursion
 */
record ElementDerivatives(
    TreePattern pattern,
    ResidualJacobian jacobian,
    TreeIteration iteration,
    Optional<ResidualDifferences> differences) {

  static ElementDerivatives of(ClosedTree work, TreePattern pattern, Derivatives derivatives) {
    ResidualJacobian jacobian = new ResidualJacobian(work.motion, pattern);
    return new ElementDerivatives(
        pattern,
        jacobian,
        new TreeIteration(work.tree, pattern, jacobian),
        derivatives == Derivatives.DIFFERENCES
            ? Optional.of(
                new ResidualDifferences(
                    jacobian, work.coordinates, pattern, work.tree.velocityCount))
            : Optional.empty());
  }
}
