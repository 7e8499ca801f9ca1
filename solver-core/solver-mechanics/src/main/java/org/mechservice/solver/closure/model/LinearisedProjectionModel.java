package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.dynamics.derivative.BorderedStep;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.ResidualDifferences;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.dynamics.derivative.StepReduction;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * RR-JF with closed loops by the second velocity transformation, or RR with derivatives by
 * differences, which large mechanisms with many freedoms need too. The equations of an implicit
 * step are reduced to one per degree of freedom,
 *
 * <pre>Rᵀ (M + hγ C + hγ² (K + Σ λ_k ∂²Φ_k)) R Δv_I = …</pre>
 *
 * <p>with K, C the derivatives of the open tree's residual (docs/theory/loops.md#projection). The
 * matrix omits the derivatives of R and γ̂, which are smaller by hγ |v| over a length; the
 * iteration makes up for them.
 */
public final class LinearisedProjectionModel extends ResidualProjectionModel
    implements LinearisedModel {
  private final StepDerivatives jacobian;
  private final Optional<ResidualDifferences> differences;
  private final StepReduction iteration;
  private final FurtherDerivatives further;
  private final BorderedStep bordered;

  /** Choices, J and position equations at the state of the last linearisation. */
  private final Partition velocities;

  private final Partition positions;
  private final SparseMatrix loopJacobian;
  private final SparseMatrix positionMatrix;

  /** λ at the state of the last linearisation. */
  public final double[] lambda;

  private final StepAlongLoops step;
  private final double[] right;
  private final double[] dependent;
  private int singular;

  /** Whether the last factorisation found pivots for all velocities. */
  private boolean isRegular;

  /** Choice of velocities at the last linearisation; a resumed run restores it. */
  private final Partition linearised;

  private boolean repeating;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public LinearisedProjectionModel(ClosedMechanism closed, UserForceSource userForces) {
    this(closed, userForces, Derivatives.RECURSIVE);
  }

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @param derivatives how the derivatives of the residual are evaluated
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public LinearisedProjectionModel(
      ClosedMechanism closed, UserForceSource userForces, Derivatives derivatives) {
    super(closed, userForces, derivatives);
    further = new FurtherDerivatives(work.nq, work.nv, work.furtherCount());
    bordered = new BorderedStep(work.coordinates, further, this::solveMechanism);
    int rank = closed.start().rank();
    int f = closed.freedom();
    boolean large = work.loops.isLarge();
    velocities = Partition.of(work.loops.jacobian, work.nv, rank, large);
    positions =
        Partition.of(completion.positionMatrix(), work.nq, completion.ofPositions().rank(), large);
    linearised = Partition.of(work.loops.jacobian, work.nv, rank, large);
    linearised.copyChoice(completion.ofVelocities());
    loopJacobian = work.loops.jacobian.sameShape();
    positionMatrix = completion.positionMatrix().sameShape();
    lambda = new double[work.loops.count()];
    if (fromLinkToLink) {
      SparseMatrix rows = work.loops.stateRows(work.nv, false);
      LinkedStep linked = LinkedStep.of(work, rows, PenaltySettings.DEFAULT.stiffness());
      jacobian = linked.jacobian();
      iteration = linked.iteration();
      differences = Optional.empty();
      step =
          new SparseStepAlongLoops(
              velocities, work.loops, rows, linked.equations(), linked.factors());
    } else {
      ElementDerivatives elements = ElementDerivatives.of(work, pattern, derivatives);
      TreeIteration tree = elements.iteration();
      jacobian = elements.jacobian();
      iteration = tree;
      differences = elements.differences();
      step =
          byMultipliers
              ? SparseStepAlongLoops.of(
                  velocities, work.loops, work.units.velocities, tree, pattern)
              : new DenseStepAlongLoops(velocities, loopJacobian, tree, work.isLarge());
    }
    right = new double[f];
    dependent = new double[positions.rank()];
  }

  @Override
  public int stateLength() {
    return super.stateLength() + linearised.stateLength();
  }

  @Override
  public void saveState(double[] state) {
    super.saveState(state);
    linearised.save(state, super.stateLength());
  }

  @Override
  public void restoreState(double[] state) {
    super.restoreState(state);
    linearised.restore(state, super.stateLength());
    repeating = true;
  }

  /**
   * {@inheritDoc} The first call of a resumed run repeats the last linearisation before the
   * checkpoint.
   */
  @Override
  public boolean linearise(double t, double[] y, double[] yDot) {
    Partition present = completion.ofVelocities();
    if (!repeating) {
      linearised.copyChoice(present);
      return lineariseAsChosen(t, y, yDot);
    }
    repeating = false;
    velocities.copyChoice(present);
    present.copyChoice(linearised);
    boolean done = lineariseAsChosen(t, y, yDot);
    present.copyChoice(velocities);
    return done;
  }

  private boolean lineariseAsChosen(double t, double[] y, double[] yDot) {
    if (evaluate(t, y, yDot) != REGULAR) {
      return false;
    }
    completion.ofVelocities().multipliers(force, lambda);
    if (differences.isPresent()) {
      if (!differences.get().evaluate(y, work.units.velocities, (at, f) -> pushed(t, at, f))
          || evaluate(t, y, yDot) != REGULAR) {
        return false;
      }
    } else if (!work.linearise(t, acceleration, 0, lambda, jacobian)) {
      fail(work.forces.defect());
      return false;
    }
    iteration.setState(y);
    completion.formPositionMatrix(y);
    loopJacobian.copy(work.loops.jacobian);
    step.linearise();
    positionMatrix.copy(completion.positionMatrix());
    bordered.setState(y);
    work.lineariseFurther(t, y, further);
    return jacobian.isFinite() && further.isFinite();
  }

  /** Forms M v' + b − τ + Jᵀ λ at another state, for the same v' and λ. */
  private boolean pushed(double t, double[] at, double[] total) {
    work.place(t, at);
    if (!work.formResidual(t, acceleration, 0, total)) {
      fail(work.forces.defect());
      return false;
    }
    for (int row = 0; row < lambda.length; row++) {
      if (lambda[row] != 0) {
        work.loops.jacobian.addRow(row, lambda[row], total, 0);
      }
    }
    return true;
  }

  @Override
  public boolean factor(double hGamma) {
    velocities.copyChoice(completion.ofVelocities());
    positions.copyChoice(completion.ofPositions());
    if (!velocities.factor(loopJacobian) || !positions.factor(positionMatrix)) {
      singular = velocities.dependent[0];
      isRegular = false;
      return false;
    }
    int velocity = step.factor(hGamma);
    isRegular = velocity == StepAlongLoops.REGULAR;
    singular = isRegular ? 0 : velocity;
    return isRegular && bordered.factor(hGamma);
  }

  /**
   * Returns the derivatives of the open tree element by element.
   *
   * @throws IllegalStateException if they are not formed, for long chains
   */
  public ResidualJacobian jacobian() {
    if (jacobian instanceof ResidualJacobian elements) {
      return elements;
    }
    throw new IllegalStateException("the equations of the step are kept by links");
  }

  /**
   * Returns the matrix of an implicit step after {@link #factor}, f × f.
   *
   * @throws IllegalStateException if it is not formed, for many degrees of freedom
   */
  public double[] reduced() {
    if (step instanceof DenseStepAlongLoops dense) {
      return dense.reduced.clone();
    }
    throw new IllegalStateException("the equations of the step are kept with multipliers");
  }

  @Override
  public void solve(double[] r) {
    bordered.solve(r);
  }

  /** Solves for the change of positions and velocities alone. */
  private void solveMechanism(double[] r) {
    completePositions(r);
    for (int j = 0; j < right.length; j++) {
      right[j] = r[work.nq + velocities.independent[j]];
    }
    Arrays.fill(r, work.nq, work.nq + work.nv, 0);
    double[] change = iteration.reduce(r);
    step.solve(right, change);
    iteration.expand(r);
  }

  /** Dependent positions of a right-hand side along the loops: P_D r_D = −P_I r_I. */
  private void completePositions(double[] r) {
    for (int i = 0; i < dependent.length; i++) {
      double sum = 0;
      int row = positions.kept[i];
      for (int e = positionMatrix.start[row]; e < positionMatrix.start[row + 1]; e++) {
        int j = positionMatrix.column[e];
        if (positions.isIndependent(j)) {
          sum -= positionMatrix.value[e] * r[j];
        }
      }
      dependent[i] = sum;
    }
    positions.solve(dependent);
    for (int i = 0; i < dependent.length; i++) {
      r[positions.dependent[i]] = dependent[i];
    }
  }

  @Override
  public int singularUnknown() {
    return isRegular ? bordered.singularUnknown() : work.nq + singular;
  }
}
