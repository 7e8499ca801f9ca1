package org.mechservice.solver.dynamics;

import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.tree.TreePattern;

/**
 * Derivatives of user forces, their own or by differences. They complete the derivatives of
 * generated code, which holds the forces' wrenches constant in the axes of their links. Workspace
 * of one thread.
 */
public final class UserForceSlopes {
  private final UserLoads loads;
  private final ResidualJacobian jacobian;
  private final int square;

  /** Prepares the slopes of these forces. */
  public UserForceSlopes(UserLoads loads) {
    this.loads = loads;
    TreePattern pattern =
        new TreePattern(
            loads.motion().tree(), LinearisedResidualModel.coupledLinks(loads.forces()));
    jacobian = new ResidualJacobian(loads.motion(), pattern);
    square = pattern.size * pattern.size;
  }

  /**
   * Adds the contributions of the last evaluated forces to the derivatives of the residual.
   *
   * @param derivatives M, ∂/∂v and ∂/∂q, each n × n row by row in the order of the state; the last
   *     two are added to
   * @return whether the derivatives are finite
   */
  public boolean addTo(double t, double[] derivatives) {
    if (!loads.linearise(t, jacobian)) {
      return false;
    }
    jacobian.byVelocity().addTo(derivatives, square);
    jacobian.byPosition().addTo(derivatives, 2 * square);
    return true;
  }
}
