package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.linear.EquilibratedSolver;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.Manifold;

/**
 * ∂F/∂y and ∂F/∂y' stored apart, so that a change of hγ costs a factorisation but no derivatives.
 * They come from the problem if it is a {@link ResidualJacobianSystem}, else from differences of F
 * in y' and in y; a {@link BandedSystem} spares the zeros outside of its band, a {@link
 * SparseSystem} evaluations for columns that share no row. Rows are equilibrated before they are
 * factored.
 *
 * <p>Later differences are taken along the step instead: moving y by δ moves y' by δ / hγ, which
 * gives hγ ∂F/∂y + ∂F/∂y' as a whole for half the evaluations. ∂F/∂y' stays as it was, and ∂F/∂y
 * becomes what makes the sum right: exact for this hγ, and for others as good as old derivatives.
 */
public final class ResidualJacobians implements ResidualLinearisation {
  /**
   * Share of y' by which F is differenced at least: F is nearly linear in y', but y' may be small
   * where the terms of F are not.
   */
  private static final double SHARE_OF_DERIVATIVE = 0x1p-17;

  private static final double SHARE_OF_STATE = 0x1p-26;

  private final ResidualSystem system;

  /** The derivatives that the problem knows. */
  private final Optional<ResidualJacobianSystem> known;

  private final Residual residual;
  private final JacobianMatrix fy;
  private final JacobianMatrix fyDot;
  private final JacobianDifferences inState;
  private final JacobianDifferences inDerivative;
  private final JacobianDifferences inStep;
  private final IterationMatrix matrix;

  /** That of hγ = 0, from when it is first asked for. */
  private Optional<IterationMatrix> unstiff = Optional.empty();

  private boolean unstiffFactored;
  private boolean unstiffRegular;

  /** Sizes of y and of y' that are negligible, length n. */
  private final double[] smallSizes;

  private final double[] smallSlopes;

  /** Sizes of the terms of F, length n. */
  private final double[] magnitude;

  /** Columns without derivative, length n. */
  private final boolean[] algebraic;

  private final AtPoint stateMoved = new AtPoint(true);
  private final AtPoint derivativeMoved = new AtPoint(false);
  private final AlongStep alongStep;

  /** Whether the differences in y' of the point are done. */
  private boolean derivativeDone;

  private boolean formed;
  private int notFiniteComponent;

  /**
   * @param smallSizes size below which a component is negligible; kept, not modified
   * @throws IllegalArgumentException if the problem's band is wider than its matrix
   */
  public ResidualJacobians(ResidualSystem system, Residual residual, double[] smallSizes) {
    int n = smallSizes.length;
    this.system = system;
    known = system.part(ResidualJacobianSystem.class);
    this.residual = residual;
    this.smallSizes = smallSizes;
    smallSlopes = smallSizes.clone();
    Manifold manifold = residual.manifold();
    matrix = newMatrix(system, manifold);
    MatrixLayout layout = matrix.layout();
    ColumnGroups groups = ColumnGroups.of(system, layout);
    fy = new JacobianMatrix(layout);
    fyDot = new JacobianMatrix(layout);
    inState = ofState(layout, groups, smallSizes, manifold);
    inDerivative =
        new JacobianDifferences(
            layout, groups, smallSlopes, manifold, SHARE_OF_DERIVATIVE, SHARE_OF_DERIVATIVE);
    inStep = ofState(layout, groups, smallSizes, manifold);
    alongStep = new AlongStep(n);
    magnitude = new double[n];
    algebraic = new boolean[n];
  }

  private static JacobianDifferences ofState(
      MatrixLayout layout, ColumnGroups groups, double[] smallSizes, Manifold manifold) {
    return new JacobianDifferences(
        layout, groups, smallSizes, manifold, SHARE_OF_STATE, JacobianDifferences.SMALLEST_SHARE);
  }

  private static IterationMatrix newMatrix(ResidualSystem system, Manifold manifold) {
    LinearSolver solver = IterationMatrix.solverFor(system, manifold.dimension());
    return new IterationMatrix(new EquilibratedSolver(solver), manifold);
  }

  @Override
  public void testColumns(ColumnTest.Maker tests) {
    inState.testColumns(tests);
    inStep.testColumns(tests);
  }

  @Override
  public boolean formsMatrix() {
    return known.isEmpty();
  }

  @Override
  public TrialOutcome formMatrix(double t, double[] y, double[] yDot, double hGamma) {
    alongStep.at(t, y, yDot, hGamma);
    if (inStep.test().isPresent()) {
      ColumnTest test = inStep.test().get();
      test.expect(1 / hGamma, fyDot.values());
      Arrays.fill(test.terms(), 0);
      fyDot.addMagnitudes(yDot, test.terms());
    }
    TrialOutcome attempt = inStep.evaluate(alongStep, y, yDot, fy.forming());
    notFiniteComponent = inStep.notFiniteComponent();
    if (attempt == TrialOutcome.PASSED) {
      fy.subtractInForming(1 / hGamma, fyDot);
      fy.replace();
      unstiffFactored = false;
    }
    return attempt;
  }

  @Override
  public void knowRate(double rate) {
    for (int l = 0; l < smallSizes.length; l++) {
      double slope = smallSizes[l] * rate;
      smallSlopes[l] = Double.isFinite(slope) ? slope : smallSizes[l];
    }
  }

  @Override
  public void abandon() {
    derivativeDone = false;
    inDerivative.abandon();
    inState.abandon();
    inStep.abandon();
  }

  @Override
  public TrialOutcome form(double t, double[] y, double[] yDot) {
    TrialOutcome attempt =
        known.isPresent()
            ? evaluateKnown(known.get(), t, y, yDot)
            : evaluateByDifferences(t, y, yDot);
    if (attempt == TrialOutcome.PASSED) {
      fy.replace();
      fyDot.replace();
      unstiffFactored = false;
      takeNote(t, y, yDot);
    }
    return attempt;
  }

  private TrialOutcome evaluateKnown(
      ResidualJacobianSystem derivatives, double t, double[] y, double[] yDot) {
    if (residual.stopped()) {
      return TrialOutcome.STOPPED;
    }
    derivatives.jacobians(
        residual.breakpoints().inside(t), y, yDot, fy.formingFromZero(), fyDot.formingFromZero());
    notFiniteComponent = Math.max(fy.rowNotFinite(), fyDot.rowNotFinite());
    return notFiniteComponent < 0 ? TrialOutcome.PASSED : TrialOutcome.NOT_FINITE;
  }

  /** Differences in y', then in y, from the same F. */
  private TrialOutcome evaluateByDifferences(double t, double[] y, double[] yDot) {
    if (!derivativeDone) {
      derivativeMoved.at(t, y);
      TrialOutcome attempt = inDerivative.evaluate(derivativeMoved, yDot, yDot, fyDot.forming());
      if (attempt != TrialOutcome.PASSED) {
        notFiniteComponent = inDerivative.notFiniteComponent();
        return attempt;
      }
      inState.knowValue(inDerivative.value());
      if (inState.test().isPresent()) {
        Arrays.fill(inState.test().get().terms(), 0);
        fyDot.addMagnitudesOfForming(yDot, inState.test().get().terms());
      }
      derivativeDone = true;
    }
    stateMoved.at(t, yDot);
    TrialOutcome attempt = inState.evaluate(stateMoved, y, yDot, fy.forming());
    notFiniteComponent = inState.notFiniteComponent();
    derivativeDone = attempt == TrialOutcome.STOPPED;
    return attempt;
  }

  private void takeNote(double t, double[] y, double[] yDot) {
    for (int l = 0; l < magnitude.length; l++) {
      magnitude[l] = 0;
    }
    fy.addMagnitudes(y, magnitude);
    fyDot.addMagnitudes(yDot, magnitude);
    inState.knowMagnitude(magnitude);
    inDerivative.knowMagnitude(magnitude);
    inStep.knowMagnitude(magnitude);
    Manifold manifold = residual.manifold();
    for (int l = 0; l < algebraic.length; l++) {
      // The column of a passive component is zero, too, but only while it is passive.
      boolean absent = manifold.independent(l) && fyDot.isZero(l);
      if (manifold.algebraic(l) && manifold.independent(l) && !absent) {
        throw new IllegalArgumentException(declaredWrongly(l, fyDot.rowOfLargest(l), t));
      }
      algebraic[l] = formed ? algebraic[l] : manifold.algebraic(l) || absent;
    }
    formed = true;
  }

  static String declaredWrongly(int component, int row, double t) {
    return "component "
        + component
        + " is declared "
        + ResidualSystem.Component.ALGEBRAIC
        + ", which leaves it out of the error test, but its derivative appears in equation "
        + row
        + " of the residual at t = "
        + t
        + "; declare it "
        + ResidualSystem.Component.DIFFERENTIAL;
  }

  @Override
  public boolean factor(double hGamma) {
    return matrix.factorResidual(hGamma, fy.values(), fyDot.values(), algebraic);
  }

  @Override
  public void solve(double hGamma, double[] r) {
    matrix.solve(r);
    for (int l = 0; l < r.length; l++) {
      if (hGamma != 0 && !algebraic[l]) {
        r[l] *= hGamma;
      }
    }
  }

  @Override
  public boolean solveUnstiff(double[] r) {
    if (unstiff.isEmpty()) {
      unstiff = Optional.of(newMatrix(system, residual.manifold()));
    }
    IterationMatrix limit = unstiff.get();
    if (!unstiffFactored) {
      unstiffRegular = limit.factorResidual(0, fy.values(), fyDot.values(), algebraic);
      unstiffFactored = true;
    }
    if (unstiffRegular) {
      limit.solve(r);
    }
    return unstiffRegular;
  }

  @Override
  public boolean algebraic(int component) {
    return algebraic[component];
  }

  /** {@inheritDoc} Derivatives that the problem knows tell whenever they are formed. */
  @Override
  public boolean doubtsDeclarations() {
    return known.isEmpty();
  }

  /** {@inheritDoc} Only a column that is zero tells, unless all is declared. */
  @Override
  public boolean allDifferential() {
    return false;
  }

  @Override
  public int singularComponent() {
    return matrix.singularColumn();
  }

  @Override
  public double reciprocalCondition() {
    return matrix.reciprocalCondition();
  }

  @Override
  public int notFiniteComponent() {
    return notFiniteComponent;
  }

  @Override
  public double magnitude(int row) {
    return magnitude[row];
  }

  @Override
  public void transfer(SavedState state) {
    fy.transfer(state);
    fyDot.transfer(state);
    inState.transfer(state);
    inDerivative.transfer(state);
    inStep.transfer(state);
    state.numbers(smallSlopes);
    state.numbers(magnitude);
    for (int l = 0; l < algebraic.length; l++) {
      algebraic[l] = state.flag(algebraic[l]);
    }
    formed = state.flag(formed);
    unstiffFactored &= !state.restoring();
    if (state.restoring() && formed) {
      inState.knowMagnitude(magnitude);
      inDerivative.knowMagnitude(magnitude);
      inStep.knowMagnitude(magnitude);
    }
  }

  /** F at a fixed t with y or y' moved and the other as it is. */
  private final class AtPoint implements DifferencedFunction {
    private final boolean movesState;
    private double t;
    private double[] fixed = {};

    AtPoint(boolean movesState) {
      this.movesState = movesState;
    }

    void at(double t, double[] fixed) {
      this.t = t;
      this.fixed = fixed;
    }

    @Override
    public boolean evaluate(double[] x, double[] value) {
      return movesState
          ? residual.evaluateCompleted(t, x, fixed, value)
          : residual.evaluate(t, fixed, x, value);
    }
  }

  /** F with y moved, and y' with it as the formula of a step moves it. */
  private final class AlongStep implements DifferencedFunction {
    private final double[] slope;
    private double t;
    private double hGamma;
    private double[] y = {};
    private double[] yDot = {};

    AlongStep(int dimension) {
      slope = new double[dimension];
    }

    void at(double t, double[] y, double[] yDot, double hGamma) {
      this.t = t;
      this.y = y;
      this.yDot = yDot;
      this.hGamma = hGamma;
    }

    @Override
    public boolean evaluate(double[] x, double[] value) {
      for (int l = 0; l < slope.length; l++) {
        slope[l] = yDot[l] + (x[l] - y[l]) / hGamma;
      }
      return residual.evaluateCompleted(t, x, slope, value);
    }
  }
}
