package org.mechservice.solver.dynamics;

import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.tree.TreePattern;

/**
 * How the forces of users change, by their own derivatives or by differences, beside derivatives
 * that code has evaluated with the forces' wrenches held fixed in the axes of their links.
 * Workspace of one thread.
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
   * Adds what the forces of the last evaluation contribute to the derivatives of the residual.
   *
   * @param derivatives M, ∂/∂v and ∂/∂q, each n × n row by row in the order of the state; the last
   *     two are added to
   * @return whether the slopes are finite
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
