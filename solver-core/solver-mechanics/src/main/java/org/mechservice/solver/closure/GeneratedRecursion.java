package org.mechservice.solver.closure;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * The equations of a large mechanism with few loops, evaluated by generated code: Φ, Φ', J and the
 * accelerations. Data-driven algorithms evaluate everything else, and whatever the code has no
 * value for; they place the state anew when they are asked. The mechanism counts no turns.
 */
final class GeneratedRecursion extends ClosedTree {
  private final LoopTerms.Recursive terms;
  private final double[] values;
  private final double[] acceleration;
  private final double[] further;

  /** Time and state of the last placement. */
  private double time;

  private final double[] state;

  /** Whether the data are placed there too. */
  private boolean swept;

  GeneratedRecursion(
      ClosedMechanism closed, UserForceSource userForces, LoopTerms.Recursive terms) {
    super(closed.tree(), userForces);
    this.terms = terms;
    values = new double[LoopTerms.Recursive.elementAt(loops.count()) + loops.jacobian.value.length];
    acceleration = new double[nv];
    further = new double[furtherCount()];
    state = new double[stateCount];
    // this call has set the sizes of the rows
    sweep(closed.start().time(), closed.start().state());
  }

  private void sweep(double t, double[] y) {
    time = t;
    System.arraycopy(y, 0, state, 0, stateCount);
    placeData(t, state);
    swept = true;
  }

  /** Places the data at the state of the last placement. */
  private void sweep() {
    if (!swept) {
      placeData(time, state);
      swept = true;
    }
  }

  @Override
  public void placeLoops(double t, double[] y) {
    place(t, y);
  }

  @Override
  public void placeRates(double t, double[] y) {
    place(t, y);
  }

  @Override
  public void place(double t, double[] y) {
    time = t;
    System.arraycopy(y, 0, state, 0, stateCount);
    swept = false;
    terms.loops(t, state, values);
    loops.takeRecursive(values);
  }

  /** {@inheritDoc} Everything else is evaluated from the data after this. */
  @Override
  public void placeEquations(double t, double[] y) {
    sweep(t, y);
  }

  @Override
  public boolean accelerations(double t, double[] y, double[] a, int at) {
    System.arraycopy(y, 0, state, 0, stateCount);
    time = t;
    swept = false;
    if (terms.equations(t, state, acceleration) != ExplicitModel.REGULAR) {
      return false;
    }
    System.arraycopy(acceleration, 0, a, at, nv);
    return true;
  }

  @Override
  public void formMass() {
    sweep();
    super.formMass();
  }

  @Override
  public boolean formBias(double t) {
    sweep();
    return super.formBias(t);
  }

  @Override
  public void formGamma(double t) {
    sweep();
    super.formGamma(t);
  }

  @Override
  public boolean formResidual(double t, double[] a, int aAt, double[] residual) {
    sweep();
    return super.formResidual(t, a, aAt, residual);
  }

  /** {@inheritDoc} Does nothing, because no turns are counted. */
  @Override
  public void accepted(double t) {}

  @Override
  public void furtherRates(double t, double[] rates, int at) {
    if (furtherCount() > 0) {
      terms.further(t, state, further);
      System.arraycopy(further, 0, rates, at, furtherCount());
    }
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    terms.energy(t, y, energy);
  }

  @Override
  public void power(double t, double[] y, double[] power) {
    swept = false;
    super.power(t, y, power);
  }

  @Override
  public void poses(double t, double[] y, double[] poses) {
    swept = false;
    super.poses(t, y, poses);
  }
}
