package org.mechservice.solver.closure.model;

import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * RR with closed loops by the second velocity transformation: F = [q_I' − (N v)_I; Rᵀ (M v' + b −
 * τ)] with v' = R v_I' + γ̂, by Newton-Euler sweeps without a mass matrix
 * (docs/theory/loops.md#projection).
 */
public class ResidualProjectionModel extends ProjectionModel implements ResidualModel {
  /** Elements of Rᵀ A R to one of A above which neither R nor the former is formed. */
  private static final int ELEMENTS = 8;

  /** Whether the equations of a step are kept by links, so that no matrix has a pattern. */
  final boolean fromLinkToLink;

  /** Pattern of the matrices of an implicit step; of no place if there are none. */
  final TreePattern pattern;

  /** Whether motions along the loops are found by multipliers instead of R. */
  final boolean byMultipliers;

  /** v', and M v' + b − τ of the last residual, one per extended velocity. */
  public final double[] acceleration;

  final double[] force;
  private final double[] reduced;

  /** Multipliers of the residual, and the residual with their forces; used without R. */
  private final double[] pushed;

  private final double[] withPush;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @param derivatives how the derivatives of the residual are evaluated
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  ResidualProjectionModel(
      ClosedMechanism closed, UserForceSource userForces, Derivatives derivatives) {
    super(closed, userForces);
    int f = closed.freedom();
    fromLinkToLink = derivatives == Derivatives.RECURSIVE && work.isEliminatedByLinks();
    int[] none = {};
    pattern =
        fromLinkToLink
            ? new TreePattern(none, none, none)
            : new TreePattern(work.tree, work.coupledLinks());
    byMultipliers =
        fromLinkToLink || (work.isLarge() && pattern.elementCount() < f * (double) f / ELEMENTS);
    pushed = new double[work.loops.count()];
    withPush = new double[work.nv];
    acceleration = new double[work.nv];
    force = new double[work.tree.velocityCount];
    reduced = new double[closed.freedom()];
  }

  /**
   * Returns RR by projection. Integrators difference its reduced residual one freedom after the
   * other; a large mechanism with many freedoms differences those together that move no common
   * force.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public static ResidualProjectionModel of(ClosedMechanism closed, UserForceSource userForces) {
    ResidualProjectionModel plain =
        new ResidualProjectionModel(closed, userForces, Derivatives.DIFFERENCES);
    return plain.byMultipliers
        ? new LinearisedProjectionModel(closed, userForces, Derivatives.DIFFERENCES)
        : plain;
  }

  /** Places a state and evaluates M v' + b − τ for the independent derivatives given. */
  final int evaluate(double t, double[] y, double[] yDot) {
    if (!canContinue()) {
      return DEFECT;
    }
    work.place(t, y);
    int begun = byMultipliers ? factorDependent() : formDirections();
    if (begun != REGULAR) {
      return begun;
    }
    work.formGamma(t);
    System.arraycopy(yDot, work.nq, acceleration, 0, work.nv);
    if (byMultipliers) {
      completion
          .ofVelocities()
          .complete(work.loops.jacobian, work.loops.acceleration, acceleration);
    } else {
      projected().formOffset(work.loops.acceleration);
      projected().compose(acceleration, 0);
    }
    return work.formResidual(t, acceleration, 0, force) ? REGULAR : fail(work.forces.defect());
  }

  private int factorDependent() {
    return completion.ofVelocities().factor(work.loops.jacobian)
        ? REGULAR
        : fail(completion.locked());
  }

  /** Writes Rᵀ (M v' + b − τ). */
  private void project() {
    if (!byMultipliers) {
      projected().project(force, reduced);
      return;
    }
    Partition partition = completion.ofVelocities();
    partition.multipliers(force, pushed);
    System.arraycopy(force, 0, withPush, 0, withPush.length);
    partition.project(work.loops.jacobian, withPush, pushed, reduced);
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
    project();
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
