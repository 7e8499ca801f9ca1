package org.mechservice.solver.closure.model;

import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * RR with closed loops by the second velocity transformation: F = [q_I' − (N v)_I; Rᵀ (M v' + b −
 * τ)] with v' = R v_I' + γ̂, by Newton-Euler sweeps without a mass matrix (NUMERICS §3).
 */
public class ResidualProjectionModel extends ProjectionModel implements ResidualModel {
  /** v', and M v' + b − τ of the last residual, one per extended velocity. */
  public final double[] acceleration;

  final double[] force;
  private final double[] reduced;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public ResidualProjectionModel(ClosedMechanism closed, UserForceSource userForces) {
    super(closed, userForces);
    acceleration = new double[work.nv];
    force = new double[work.tree.velocityCount];
    reduced = new double[closed.freedom()];
  }

  /** Places a state and evaluates M v' + b − τ for the independent derivatives given. */
  final int evaluate(double t, double[] y, double[] yDot) {
    if (!goesOn()) {
      return DEFECT;
    }
    work.place(t, y);
    int begun = formDirections();
    if (begun != REGULAR) {
      return begun;
    }
    work.formGamma(t);
    projected().formOffset(work.loops.acceleration);
    System.arraycopy(yDot, work.nq, acceleration, 0, work.nv);
    projected().compose(acceleration, 0);
    return work.formResidual(t, acceleration, 0, force) ? REGULAR : fail(work.forces.defect());
  }

  /** {@inheritDoc} Dependent components of the residual are set to zero. */
  @Override
  public final int residual(double t, double[] y, double[] yDot, double[] residual) {
    int evaluated = evaluate(t, y, yDot);
    if (evaluated != REGULAR) {
      return evaluated;
    }
    work.coordinates.rates(y, 0, y, work.nq, residual, 0);
    for (int i = 0; i < work.nq; i++) {
      residual[i] = completion.independent(i) ? yDot[i] - residual[i] : 0;
    }
    projected().project(force, reduced);
    for (int j = 0; j < work.nv; j++) {
      residual[work.nq + j] = 0;
    }
    int[] independent = completion.ofVelocities().independent;
    for (int j = 0; j < independent.length; j++) {
      residual[work.nq + independent[j]] = reduced[j];
    }
    work.furtherRates(t, residual, work.furtherAt);
    for (int i = work.furtherAt; i < work.stateCount; i++) {
      residual[i] = yDot[i] - residual[i];
    }
    return REGULAR;
  }
}
