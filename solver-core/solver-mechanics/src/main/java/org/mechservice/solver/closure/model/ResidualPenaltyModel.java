package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleToIntFunction;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.closure.AugmentedEquations;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.DenseAugmentedEquations;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.SparseAugmentedEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.dynamics.derivative.BorderedStep;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.ResidualDifferences;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.dynamics.derivative.StepReduction;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * RR and RR-JF with closed loops by penalty: the stabilised equations of index 2 (Gear, Gupta and
 * Leimkuhler 1985) in y = [q; v; s; λ; μ],
 *
 * <pre>F = [q' − N (v − Jᵀ μ); M v' + b − τ + Jᵀ λ; J v + Φ_t; Φ],</pre>
 *
 * <p>with rows of J divided by their sizes, and columns in the coordinates' units in the term Jᵀ μ.
 * Error tests leave λ and μ out. The equations of an implicit step are solved by the augmented
 * Lagrangian method: a penalty replaces the zero block, and iteration removes its error
 * (docs/theory/loops.md#penalty). Rows that are redundant at the linearisation are left out, with λ
 * and μ zero: predicted states lie off the loops, where such rows slightly contradict the others,
 * and multipliers would grow without bound. The matrix omits the derivative of J v by q, because it
 * is kept over several steps; every solution is corrected by the rates at the state that it leads
 * to. The matrix also omits the derivative of Jᵀ μ, for which the iteration makes up. Equations
 * that restrict velocities alone have no Φ, and their μ is zero.
 */
public final class ResidualPenaltyModel extends PenaltyModel implements LinearisedModel {
  /** Method for the derivatives of the equations of motion. */
  public enum Derivatives {
    /** Analytic derivatives by recursion: RR-JF. */
    RECURSIVE,
    /** Difference quotients: RR. */
    DIFFERENCES
  }

  private static final int REPETITIONS = 3;

  /**
   * Scaled pivot below which an equation counts as redundant. On the way of a mechanism that moves
   * by symmetry, such as one of parallel rods, such a pivot is an error of the prediction.
   */
  private static final double HIDDEN = 1e-5;

  /** Relative residual that assembly leaves, in addition to rounding. */
  private static final double ROUNDING = 2e-13;

  /**
   * Relative rates that the iteration leaves. The projection leaves as much, so that a start from
   * projected states needs no change of them; a hundred times more grows in later predictions until
   * fine tolerances notice it.
   */
  private static final double RATE_ROUNDING = 1e-13;

  private final StepDerivatives jacobian;
  private final Optional<ResidualDifferences> differences;
  private final StepReduction iteration;

  /** Factors {@link #equations} for hγ; a negative number, or the velocity without a pivot. */
  private final DoubleToIntFunction factors;

  private final int n;
  private final int m;

  /** J with scaled rows at the state of F and at the linearisation, m × n. */
  private final SparseMatrix rows;

  private final SparseMatrix linearisedRows;

  /** The rows at the linearisation that restrict positions; the others are zero. */
  private final SparseMatrix positionRows;

  private final double[] force;
  private final double[] velocity;
  private final double[] lambda;
  private final AugmentedEquations equations;
  private final PositionCorrection correction;
  private final double[] right;
  private final double[] ofVelocity;
  private final double[] ofPosition;
  private final double[] mu;

  /** Independent rows, chosen at the linearisation, and the redundant ones. */
  private final Partition independent;

  private final boolean[] isRepeated;

  /** Time and state of the last residual, and a neighbouring state. */
  private double time;

  private final double[] state;
  private final double[] moved;

  /** Positions of a reduced right-hand side, and the change of λ times hγ. */
  private final double[] reduced;

  private final double[] push;
  private final double[] none;
  private double hGamma;
  private int singular;

  /** Whether the last factorisation found pivots for all velocities. */
  private boolean regular;

  private final FurtherDerivatives further;
  private final BorderedStep bordered;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public ResidualPenaltyModel(
      ClosedMechanism closed,
      UserForceSource userForces,
      PenaltySettings settings,
      Derivatives derivatives) {
    super(closed, userForces, settings);
    n = work.nv;
    m = work.loops.count();
    rows = work.loops.stateRows(n, false);
    linearisedRows = rows.sameShape();
    positionRows = work.loops.isHolonomic() ? linearisedRows : rows.sameShape();
    force = new double[work.tree.velocityCount];
    velocity = new double[n];
    lambda = new double[m];
    double[] units = work.units.velocities;
    if (derivatives == Derivatives.RECURSIVE && work.isEliminatedByLinks()) {
      LinkedStep linked = LinkedStep.of(work, linearisedRows, settings.stiffness());
      jacobian = linked.jacobian();
      iteration = linked.iteration();
      differences = Optional.empty();
      equations = linked.equations();
      factors = linked.factors();
    } else {
      TreePattern pattern = new TreePattern(work.tree, work.coupledLinks());
      ElementDerivatives elements = ElementDerivatives.of(work, pattern, derivatives);
      TreeIteration tree = elements.iteration();
      jacobian = elements.jacobian();
      iteration = tree;
      differences = elements.differences();
      if (work.loops.isLarge()) {
        SparseAugmentedEquations sparse =
            new SparseAugmentedEquations(linearisedRows, units, pattern);
        equations = sparse;
        factors = step -> sparse.factor(formed(tree, step), penalty(tree.matrix()));
      } else {
        DenseAugmentedEquations dense = DenseAugmentedEquations.general(linearisedRows, units);
        equations = dense;
        factors = step -> dense.factor(formed(tree, step), penalty(tree.matrix()));
      }
    }
    correction =
        work.loops.isLarge()
            ? new SparsePositionCorrection(positionRows, units)
            : new DensePositionCorrection(positionRows, units);
    right = new double[n];
    ofVelocity = new double[m];
    ofPosition = new double[m];
    mu = new double[m];
    independent = Partition.of(work.loops.jacobian, n, closed.start().rank(), work.loops.isLarge());
    double[] sizes = new double[m];
    Arrays.setAll(sizes, row -> 1 / work.loops.size(row));
    independent.scale(sizes, work.units.velocities);
    isRepeated = new boolean[m];
    findRepeated();
    state = new double[work.stateCount];
    moved = new double[work.stateCount];
    further = new FurtherDerivatives(work.nq, n, work.furtherCount());
    bordered =
        new BorderedStep(
            work.coordinates,
            further,
            work.stateCount + 2 * m,
            r -> solveMechanism(r, false),
            r -> solveMechanism(r, true));
    reduced = new double[work.nq];
    push = new double[m];
    none = new double[n];
  }

  @Override
  public int unknownCount() {
    return work.stateCount + 2 * m;
  }

  @Override
  public boolean isDifferential(int unknown) {
    return unknown < work.stateCount;
  }

  @Override
  public int consistent(double t, double[] y, double[] yDot) {
    int done = derivative(t, y, yDot);
    int at = work.stateCount;
    Arrays.fill(y, at, at + 2 * m, 0);
    Arrays.fill(yDot, at, at + 2 * m, 0);
    System.arraycopy(projection.equations().multipliers(), 0, y, at, m);
    return done;
  }

  @Override
  public int residual(double t, double[] y, double[] yDot, double[] residual) {
    if (!formForce(t, y, yDot)) {
      return fail(work.forces.defect());
    }
    int atLambda = work.stateCount;
    int atMu = atLambda + m;
    time = t;
    System.arraycopy(y, 0, state, 0, state.length);
    formRows(rows);
    System.arraycopy(y, work.nq, velocity, 0, n);
    addTransposed(rows, y, atMu, -1, true, velocity);
    work.coordinates.rates(y, 0, velocity, 0, residual, 0);
    for (int i = 0; i < work.nq; i++) {
      residual[i] = yDot[i] - residual[i];
    }
    addTransposed(rows, y, atLambda, 1, false, force);
    System.arraycopy(force, 0, residual, work.nq, n);
    work.furtherRates(t, residual, work.furtherAt);
    for (int i = work.furtherAt; i < work.stateCount; i++) {
      residual[i] = yDot[i] - residual[i];
    }
    double speed = work.units.speed(y, work.nq);
    for (int row = 0; row < m; row++) {
      double size = work.loops.size(row);
      boolean repeats = isRepeated[row];
      double leftAlone = projection.rounding.leftAlone(row, y);
      residual[atLambda + row] =
          repeats
              ? y[atLambda + row]
              : LoopRounding.beyond(
                  (RATE_ROUNDING + leftAlone) * speed, work.loops.rate[row] / size);
      residual[atMu + row] =
          repeats || !work.loops.isHolonomic(row)
              ? y[atMu + row]
              : LoopRounding.beyond(ROUNDING + leftAlone, work.loops.value[row] / size);
    }
    return REGULAR;
  }

  /** Finds the redundant rows at the placed state. */
  private void findRepeated() {
    if (independent.choose(work.loops.jacobian)) {
      independent.listLeftOut(isRepeated);
      if (independent.bestPivot() < HIDDEN) {
        isRepeated[independent.weakestRow()] = true;
      }
    }
  }

  /** Forms J with scaled rows; redundant rows are zero. */
  private void formRows(SparseMatrix j) {
    work.loops.scaledRows(j);
    for (int row = 0; row < m; row++) {
      if (isRepeated[row]) {
        Arrays.fill(j.value, j.start[row], j.start[row + 1], 0);
      }
    }
  }

  /** Forms M v' + b − τ without the loops; returns false if a force has no value. */
  private boolean formForce(double t, double[] y, double[] yDot) {
    work.place(t, y);
    return work.formResidual(t, yDot, work.nq, force);
  }

  /** Adds factor Jᵀ λ or factor U² Jᵀ λ to x. */
  private void addTransposed(
      SparseMatrix j, double[] multipliers, int at, double factor, boolean inUnits, double[] x) {
    double[] unit = work.units.velocities;
    for (int row = 0; row < m; row++) {
      double push = factor * multipliers[at + row];
      for (int e = j.start[row]; push != 0 && e < j.start[row + 1]; e++) {
        int k = j.column[e];
        x[k] += push * j.value[e] * (inUnits ? unit[k] * unit[k] : 1);
      }
    }
  }

  @Override
  public boolean linearise(double t, double[] y, double[] yDot) {
    int atLambda = work.stateCount;
    work.place(t, y);
    findRepeated();
    if (differences.isPresent()) {
      work.placeLinks(t, y);
      if (!differences
          .get()
          .evaluate(y, work.units.velocities, (at, f) -> pushed(t, at, y, yDot, f))) {
        return false;
      }
      work.place(t, y);
    } else {
      if (!formForce(t, y, yDot)) {
        fail(work.forces.defect());
        return false;
      }
      for (int row = 0; row < m; row++) {
        lambda[row] = isRepeated[row] ? 0 : y[atLambda + row] / work.loops.size(row);
      }
      if (!work.linearise(t, yDot, work.nq, lambda, jacobian)) {
        fail(work.forces.defect());
        return false;
      }
    }
    formRows(linearisedRows);
    equations.linearise();
    formPositionRows();
    iteration.setState(y);
    bordered.setState(y);
    work.lineariseFurther(t, y, further);
    return jacobian.isFinite() && further.isFinite();
  }

  private void formPositionRows() {
    if (positionRows != linearisedRows) {
      positionRows.copy(linearisedRows);
      for (int row = 0; row < m; row++) {
        if (!work.loops.isHolonomic(row)) {
          Arrays.fill(positionRows.value, positionRows.start[row], positionRows.start[row + 1], 0);
        }
      }
    }
  }

  /** Forms M v' + b − τ + Jᵀ λ at another state, for the same v' and λ. */
  private boolean pushed(double t, double[] at, double[] y, double[] yDot, double[] pushed) {
    if (!formForce(t, at, yDot)) {
      fail(work.forces.defect());
      return false;
    }
    formRows(rows);
    System.arraycopy(force, 0, pushed, 0, force.length);
    addTransposed(rows, y, work.stateCount, 1, false, pushed);
    return true;
  }

  @Override
  public boolean factor(double hGamma) {
    this.hGamma = hGamma;
    singular = factors.applyAsInt(hGamma);
    regular = singular < 0 && factorCorrection();
    return regular && bordered.factor(hGamma);
  }

  private static TreeSquare formed(TreeIteration tree, double step) {
    tree.form(step);
    return tree.matrix();
  }

  /** Returns α of a row of unit length. */
  private double penalty(TreeSquare matrix) {
    double largest = 0;
    for (int j = 0; j < n; j++) {
      double unit = work.units.velocities[j];
      largest = Math.max(largest, Math.abs(matrix.get(j, j)) * unit * unit);
    }
    return settings.stiffness() * largest;
  }

  private boolean factorCorrection() {
    singular = 0;
    return correction.factor();
  }

  @Override
  public void solve(double[] r) {
    bordered.solve(r);
  }

  /**
   * Solves for the change of positions, velocities and multipliers.
   *
   * @param corrects whether velocities are corrected so that they satisfy the loops at the changed
   *     positions, which is not linear
   */
  private void solveMechanism(double[] r, boolean corrects) {
    int atLambda = work.stateCount;
    int atMu = atLambda + m;
    double[] change = iteration.reduce(r);
    for (int row = 0; row < m; row++) {
      boolean repeats = isRepeated[row];
      ofVelocity[row] = repeats ? 0 : -r[atLambda + row] / hGamma;
      ofPosition[row] =
          repeats || !work.loops.isHolonomic(row)
              ? 0
              : linearisedRows.product(row, iteration.tangent(), 0) / hGamma
                  - r[atMu + row] / (hGamma * hGamma);
    }
    System.arraycopy(r, 0, reduced, 0, work.nq);
    System.arraycopy(change, 0, right, 0, n);
    equations.solve(right, ofVelocity, velocity, 0);
    System.arraycopy(equations.multipliers, 0, push, 0, m);
    complete(r, change);
    if (corrects) {
      correctVelocities(r);
      System.arraycopy(reduced, 0, r, 0, work.nq);
      complete(r, change);
    }
    for (int row = 0; row < m; row++) {
      boolean repeats = isRepeated[row];
      r[atLambda + row] = (repeats ? r[atLambda + row] : push[row]) / hGamma;
      r[atMu + row] = repeats || !work.loops.isHolonomic(row) ? r[atMu + row] / hGamma : mu[row];
    }
  }

  /**
   * Completes the change of the state from that of the velocities; r holds the reduced positions.
   */
  private void complete(double[] r, double[] change) {
    System.arraycopy(velocity, 0, change, 0, n);
    correctPositions(change);
    iteration.expand(r);
    System.arraycopy(velocity, 0, r, work.nq, n);
  }

  /** Corrects velocities so that they satisfy the loops at the changed positions. */
  private void correctVelocities(double[] r) {
    for (int i = 0; i < moved.length; i++) {
      moved[i] = state[i] + r[i];
    }
    work.placeRates(time, moved);
    double speed = work.units.speed(moved, work.nq);
    for (int row = 0; row < m; row++) {
      double leftAlone = RATE_ROUNDING + projection.rounding.leftAlone(row, moved);
      ofVelocity[row] =
          isRepeated[row]
              ? 0
              : LoopRounding.beyond(leftAlone * speed, work.loops.rate[row] / work.loops.size(row));
    }
    equations.solve(none, ofVelocity, right, 0);
    for (int k = 0; k < n; k++) {
      velocity[k] += right[k];
    }
    for (int row = 0; row < m; row++) {
      push[row] += equations.multipliers[row];
    }
  }

  /** Δw = Δv − U² Jᵀ Δμ, so that J Δw meets the positions. */
  private void correctPositions(double[] change) {
    Arrays.fill(mu, 0);
    for (int i = 0; i < REPETITIONS; i++) {
      for (int row = 0; row < m; row++) {
        lambda[row] = positionRows.product(row, change, 0) + ofPosition[row];
      }
      correction.solve(lambda);
      addTransposed(positionRows, lambda, 0, -1, true, change);
      for (int row = 0; row < m; row++) {
        mu[row] += lambda[row];
      }
    }
  }

  @Override
  public int singularUnknown() {
    return regular ? bordered.singularUnknown() : work.nq + Math.max(0, singular);
  }
}
