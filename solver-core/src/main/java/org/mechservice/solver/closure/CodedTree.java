package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.dynamics.ResidualJacobian;
import org.mechservice.solver.force.UserForceSource;

/**
 * The equations of a mechanism with loops, evaluated by code that was written for it. The data
 * serve what is asked for seldom: poses, reactions, and the reason where a force has no direction.
 *
 * <p>Nothing counts whole turns here: code is written only where neither a force nor a relation
 * depends on coordinates of cut joints.
 */
final class CodedTree extends ClosedTree {
  private final LoopTerms terms;
  private final UserForceSource userForces;
  private final int m;
  private final double[] values;
  private final double[] bias;

  /** Accelerations and residual of the state's velocities alone. */
  private final double[] acceleration;

  private final double[] residual;

  /** M, ∂/∂v and ∂/∂q of the residual; elements that are never written are zero. */
  private final double[] derivatives;

  /** A residual of the data. */
  private final double[] extended;

  /** Time and state of the last placement. */
  private double time;

  private final double[] state;

  /** What the equations returned there, and whether they were evaluated there. */
  private int result;

  private boolean formed;

  CodedTree(ClosedMechanism closed, UserForceSource userForces, LoopTerms terms) {
    super(closed.tree(), userForces);
    this.terms = terms;
    this.userForces = userForces;
    m = loops.count();
    values = new double[LoopTerms.count(m, nv)];
    bias = new double[nv];
    acceleration = new double[nv];
    residual = new double[nv];
    derivatives = new double[terms instanceof LoopTerms.OfDerivatives ? 3 * nv * nv : 0];
    extended = new double[tree.velocityCount];
    state = closed.start();
    // rows have learned here what they measure
    placeData(closed.startTime(), state);
  }

  @Override
  ClosedTree ofData() {
    return new ClosedTree(tree, userForces);
  }

  private void remember(double t, double[] y) {
    time = t;
    System.arraycopy(y, 0, state, 0, state.length);
  }

  @Override
  void placeLoops(double t, double[] y) {
    place(t, y);
  }

  @Override
  void placeRates(double t, double[] y) {
    place(t, y);
  }

  @Override
  void place(double t, double[] y) {
    remember(t, y);
    formed = false;
    terms.loops(t, y, values);
    loops.take(values, nv);
  }

  @Override
  void placeEquations(double t, double[] y) {
    remember(t, y);
    form();
    loops.take(values, nv);
  }

  private void form() {
    result = terms.equations(time, state, values);
    formed = true;
    System.arraycopy(values, LoopTerms.offsetAt(m, nv), loops.acceleration, 0, m);
    System.arraycopy(values, LoopTerms.biasAt(m, nv), bias, 0, nv);
    takeMass(LoopTerms.massAt(m, nv));
  }

  private void takeMass(int at) {
    for (int i = 0; i < nv; i++) {
      for (int j = 0; j <= i; j++) {
        double element = values[at + i * nv + j];
        mass[i * nv + j] = element;
        mass[j * nv + i] = element;
      }
    }
  }

  /** {@inheritDoc} They do not depend on the forces, which may have no direction. */
  @Override
  void formMass() {
    if (!formed) {
      form();
    }
    if (result != ExplicitModel.REGULAR) {
      motion.sweep(time, state);
      super.formMass();
    }
  }

  @Override
  boolean formBias(double t) {
    if (result == ExplicitModel.REGULAR) {
      return true;
    }
    // the data know the reason, or, at the very limit, the value
    placeData(time, state);
    boolean regular = super.formBias(t);
    System.arraycopy(super.bias(), 0, bias, 0, nv);
    return regular;
  }

  @Override
  double[] bias() {
    return bias;
  }

  @Override
  void formGamma(double t) {
    ofResidual().offset(t, state, values);
    System.arraycopy(values, LoopTerms.offsetAt(m, nv), loops.acceleration, 0, m);
  }

  private LoopTerms.OfResidual ofResidual() {
    return (LoopTerms.OfResidual) terms;
  }

  @Override
  boolean formResidual(double t, double[] a, int aAt, double[] target) {
    System.arraycopy(a, aAt, acceleration, 0, nv);
    if (ofResidual().residual(t, state, acceleration, residual) != ExplicitModel.REGULAR) {
      placeData(t, state);
      return super.formResidual(t, a, aAt, target);
    }
    Arrays.fill(target, 0);
    System.arraycopy(residual, 0, target, 0, nv);
    return true;
  }

  @Override
  void energy(double t, double[] y, double[] energy) {
    terms.energy(t, y, energy);
  }

  @Override
  void power(double t, double[] y, double[] power) {
    Arrays.fill(power, 0);
    terms.power(t, y, power);
  }

  /** {@inheritDoc} The data do it where the code has no derivatives, or a force no value. */
  @Override
  boolean linearise(double t, double[] a, int aAt, double[] lambda, ResidualJacobian jacobian) {
    if (terms instanceof LoopTerms.OfDerivatives coded) {
      System.arraycopy(a, aAt, acceleration, 0, nv);
      if (coded.derivatives(t, state, acceleration, lambda, derivatives) == ExplicitModel.REGULAR) {
        jacobian.take(derivatives);
        return true;
      }
    }
    placeData(t, state);
    return super.formResidual(t, a, aAt, extended) && super.linearise(t, a, aAt, lambda, jacobian);
  }

  @Override
  void accepted(double t) {
    // Nothing counts on from an accepted state.
  }
}
