package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * The equations of a mechanism with loops, evaluated by generated code. Data-driven algorithms
 * evaluate what is rarely needed: reactions, poses of models built without pose output, and the
 * reason why a force has no direction.
 *
 * <p>The unwrapped angles of cut joints follow the state in the code's argument; the code takes
 * whole turns from them.
 */
final class GeneratedTreeTerms extends ClosedTree {
  /** Index of the first Euler parameter among the numbers of a body. */
  private static final int FIRST_EULER_PARAMETER = 3;

  private static final int EULER_PARAMETERS = 4;

  private final LoopTerms terms;
  private final Optional<LoopTerms.OfPoses> ofPoses;
  private final UserForceSource userForces;
  private final int m;
  private final double[] values;
  private final double[] bias;

  /** Accelerations and residual of the state's velocities alone. */
  private final double[] acceleration;

  private final double[] residual;

  /** M, ∂/∂v and ∂/∂q of the residual; elements that are never written are zero. */
  private final double[] derivatives;

  /** Residual evaluated from the data. */
  private final double[] extended;

  private final UnwrappedAngles angles;

  /** Unwrapped coordinates of cut joints at the last accepted step, from the data. */
  private final double[] counted;

  private Optional<ClosedTree> following = Optional.empty();

  /** Time and state of the last placement, and behind it the counted angles. */
  private double time;

  private final double[] state;

  /** State for energy and power alone, followed by the unwrapped angles. */
  private final double[] beside;

  /** Result of the equations at that state, and whether they were evaluated there. */
  private int result;

  private boolean formed;

  /** Whether code wrote the derivatives of the last linearisation. */
  private boolean derived;

  /** Derivatives of the further states. */
  private final double[] further;

  GeneratedTreeTerms(ClosedMechanism closed, UserForceSource userForces, LoopTerms terms) {
    super(closed.tree(), userForces);
    this.terms = terms;
    ofPoses = terms.poses();
    this.userForces = userForces;
    m = loops.count();
    values = new double[LoopTerms.count(m, nv)];
    bias = new double[nv];
    acceleration = new double[nv];
    residual = new double[nv];
    derivatives =
        new double
            [terms instanceof LoopTerms.OfDerivatives
                ? 3 * nv * nv + FurtherDerivatives.numbers(nv, furtherCount())
                : 0];
    further = new double[furtherCount()];
    extended = new double[tree.velocityCount];
    counted = new double[super.stateLength()];
    angles = new UnwrappedAngles(tree);
    state = angles.behind(closed.start().state());
    beside = state.clone();
    // this call has set the sizes of the rows
    placeData(closed.start().time(), state);
  }

  @Override
  public ClosedTree ofData() {
    ClosedTree other = new ClosedTree(tree, userForces);
    following = Optional.of(other);
    copyAnglesToData();
    return other;
  }

  /** Copies the unwrapped angles to the data-driven workspace. */
  private void copyAnglesToData() {
    if (following.isPresent()) {
      super.save(counted, 0);
      following.get().restore(counted, 0);
    }
  }

  /** {@inheritDoc} Generated code always forms a dense mass matrix. */
  @Override
  public boolean isLarge() {
    return false;
  }

  private void remember(double t, double[] y) {
    time = t;
    System.arraycopy(y, 0, state, 0, stateCount);
  }

  private double[] beside(double[] y) {
    System.arraycopy(state, stateCount, beside, stateCount, angles.count());
    System.arraycopy(y, 0, beside, 0, stateCount);
    return beside;
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
    remember(t, y);
    formed = false;
    terms.loops(t, state, values);
    loops.take(values, nv);
  }

  @Override
  public void placeEquations(double t, double[] y) {
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
        mass()[i * nv + j] = element;
        mass()[j * nv + i] = element;
      }
    }
  }

  /**
   * {@inheritDoc} The mass matrix does not depend on the forces, so a force without direction does
   * no harm.
   */
  @Override
  public void formMass() {
    if (!formed) {
      form();
    }
    if (result != ExplicitModel.REGULAR) {
      motion.sweep(time, state);
      super.formMass();
    }
  }

  @Override
  public boolean formBias(double t) {
    if (result == ExplicitModel.REGULAR) {
      return true;
    }
    // the data-driven evaluation gives the reason or, at the very limit, the value
    placeData(time, state);
    boolean regular = super.formBias(t);
    System.arraycopy(super.bias(), 0, bias, 0, nv);
    return regular;
  }

  @Override
  public double[] bias() {
    return bias;
  }

  @Override
  public void formGamma(double t) {
    ofResidual().offset(t, state, values);
    System.arraycopy(values, LoopTerms.offsetAt(m, nv), loops.acceleration, 0, m);
  }

  private LoopTerms.OfResidual ofResidual() {
    return (LoopTerms.OfResidual) terms;
  }

  @Override
  public boolean formResidual(double t, double[] a, int aAt, double[] target) {
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
  public void furtherRates(double t, double[] rates, int at) {
    if (furtherCount() > 0) {
      terms.further(t, state, further);
      System.arraycopy(further, 0, rates, at, furtherCount());
    }
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    terms.energy(t, beside(y), energy);
  }

  @Override
  public void power(double t, double[] y, double[] power) {
    Arrays.fill(power, 0);
    terms.power(t, beside(y), power);
  }

  @Override
  public void poses(double t, double[] y, double[] poses) {
    if (ofPoses.isEmpty()) {
      super.poses(t, y, poses);
      return;
    }
    ofPoses.get().poses(t, y, poses);
    for (int e = FIRST_EULER_PARAMETER; e < poses.length; e += BodyPoses.NUMBERS_PER_BODY) {
      if (poses[e] < 0) {
        for (int i = e; i < e + EULER_PARAMETERS; i++) {
          poses[i] = 0 - poses[i];
        }
      }
    }
  }

  /** {@inheritDoc} The data are used if the code has no derivatives or a force has no value. */
  @Override
  public boolean linearise(
      double t, double[] a, int aAt, double[] lambda, StepDerivatives jacobian) {
    derived = false;
    if (terms instanceof LoopTerms.OfDerivatives coded
        && jacobian instanceof ResidualJacobian elements) {
      System.arraycopy(a, aAt, acceleration, 0, nv);
      if (coded.derivatives(t, state, acceleration, lambda, derivatives) == ExplicitModel.REGULAR) {
        elements.take(derivatives);
        derived = true;
        return true;
      }
    }
    placeData(t, state);
    return super.formResidual(t, a, aAt, extended) && super.linearise(t, a, aAt, lambda, jacobian);
  }

  /** {@inheritDoc} The data are used unless code has just written the derivatives. */
  @Override
  public void lineariseFurther(double t, double[] y, FurtherDerivatives further) {
    if (derived) {
      further.take(derivatives, 3 * nv * nv);
    } else {
      super.lineariseFurther(t, y, further);
    }
  }

  /** {@inheritDoc} Does nothing if there are no unwrapped angles. */
  @Override
  public void accepted(double t) {
    if (angles.count() > 0) {
      placeData(time, state);
      super.accepted(t);
      angles.follow(motion, state, stateCount);
      copyAnglesToData();
    }
  }

  @Override
  public int stateLength() {
    return super.stateLength() + angles.count();
  }

  @Override
  public void save(double[] saved, int at) {
    super.save(saved, at);
    System.arraycopy(state, stateCount, saved, at + super.stateLength(), angles.count());
  }

  @Override
  public void restore(double[] saved, int at) {
    super.restore(saved, at);
    System.arraycopy(saved, at + super.stateLength(), state, stateCount, angles.count());
    copyAnglesToData();
  }
}
