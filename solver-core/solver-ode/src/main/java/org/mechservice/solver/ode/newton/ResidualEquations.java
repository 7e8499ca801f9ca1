package org.mechservice.solver.ode.newton;

import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.Breakpoints;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * The equations of a step for F(t, y, y') = 0. The formulas give y' = (ψ + d) / hγ at the new
 * point, and the iteration solves
 *
 * <pre>
 * (hγ ∂F/∂y + ∂F/∂y') δ = −hγ F(t_{n+1}, y* + d, (ψ + d) / hγ);    hγ = h / ((1 − κ_k) γ_k)
 * </pre>
 */
public final class ResidualEquations extends StepEquations {
  /** Part of the step by which the start looks ahead to estimate y''. */
  private static final double LOOK_AHEAD = 0x1p-10;

  private static final double FIRST_STEP_PART = 0.1;
  private static final double FIRST_STEP_SHARE = 1e-3;

  private final Residual residual;
  private final ResidualLinearisation linearisation;
  private final ConsistentStart start;
  private final NegligibleResidual slight;

  /** Whether both derivatives are formed every time. */
  private boolean asPublished;

  /** A small change of a component over a step, relative to its size. */
  private final double smallMove;

  /** y' at the last accepted point, length n. */
  private final double[] slope;

  /** y' at the iterate, and F there, length n. */
  private final double[] iterateSlope;

  private final double[] value;

  /** y ahead of the start, and F at the start, length n. */
  private final double[] ahead;

  private final double[] valueAtStart;

  /** What is left of the equations that are not solved better than before, length n. */
  private final double[] unsolved;

  /** F where y is moved, length n. */
  private final double[] moved;

  /** Where F was evaluated last for the iteration. */
  private double evaluatedTime;

  /** Whether F at the start is known from a call that was stopped. */
  private boolean valueKnown;

  /** Whether a step has been solved, and whether declarations were looked at again since. */
  private boolean beyondStart;

  private boolean declarationsSeen;

  /** hγ of the matrix for the start: 0 unless that is singular. */
  private double startHGamma;

  /**
   * @param yDot0 guess of y' at the start; not modified
   * @param tEnd end of the problem
   * @param norm by which its errors will be judged
   */
  public ResidualEquations(
      Residual residual,
      ResidualLinearisation linearisation,
      double[] yDot0,
      double tEnd,
      ErrorNorm norm,
      IntegratorSettings settings) {
    super(
        residual.manifold(),
        residual.massMatrixMoves()
            ? MatrixDrift.of(linearisation.formsMatrix())
            : MatrixDrift.none());
    this.residual = residual;
    this.linearisation = linearisation;
    smallMove = Math.sqrt(settings.relativeTolerance());
    slope = yDot0.clone();
    start = new ConsistentStart(this, norm, settings, tEnd);
    int n = slope.length;
    iterateSlope = new double[n];
    value = new double[n];
    ahead = new double[n];
    valueAtStart = new double[n];
    unsolved = new double[n];
    moved = new double[n];
    slight = new NegligibleResidual(linearisation, residual.manifold());
  }

  Residual residual() {
    return residual;
  }

  ResidualLinearisation linearisation() {
    return linearisation;
  }

  @Override
  public Breakpoints breakpoints() {
    return residual.breakpoints();
  }

  @Override
  public boolean stopped() {
    return residual.stopped();
  }

  @Override
  void abandon() {
    linearisation.abandon();
    start.abandon();
    valueKnown = false;
  }

  @Override
  public TrialOutcome findStart(double t, double[] y, double[] slope0) {
    TrialOutcome attempt = start.find(t, y, slope);
    System.arraycopy(slope, 0, slope0, 0, slope.length);
    return attempt;
  }

  @Override
  public void stateChanged() {
    start.stateChanged();
  }

  @Override
  public Cause causeAtStart(TrialOutcome attempt) {
    return switch (attempt) {
      case SINGULAR_MATRIX -> Cause.SINGULAR_MATRIX;
      case NOT_FINITE -> Cause.NOT_FINITE;
      case NOT_COMPLETED -> Cause.NOT_COMPLETED;
      default -> Cause.INCONSISTENT_START;
    };
  }

  @Override
  public int componentAtStart(TrialOutcome attempt) {
    return switch (attempt) {
      case SINGULAR_MATRIX -> singularComponent();
      case NOT_COMPLETED -> -1;
      default -> start.worstRow();
    };
  }

  @Override
  TrialOutcome formDerivatives(double t, double[] y) {
    slight.forget();
    return linearisation.form(t, y, slope);
  }

  @Override
  TrialOutcome formAhead(double t, double hGamma, BackwardDifferences differences) {
    slight.forget();
    for (int l = 0; l < ahead.length; l++) {
      ahead[l] = differences.psi[l] / hGamma;
    }
    return linearisation.form(t, differences.predicted, ahead);
  }

  @Override
  boolean formsMatrix() {
    return !asPublished && !drift().matters() && linearisation.formsMatrix();
  }

  @Override
  TrialOutcome formMatrix(double t, double[] y, double hGamma) {
    slight.forget();
    return linearisation.formMatrix(t, y, slope, hGamma);
  }

  @Override
  boolean formFactors(double hGamma) {
    return linearisation.factor(hGamma);
  }

  @Override
  int singularComponent() {
    return linearisation.singularComponent();
  }

  @Override
  double reciprocalCondition() {
    return linearisation.reciprocalCondition();
  }

  @Override
  boolean evaluate(double t, double hGamma, BackwardDifferences differences, double[] r) {
    evaluatedTime = t;
    double[] psi = differences.psi;
    double[] correction = differences.correction;
    for (int l = 0; l < iterateSlope.length; l++) {
      iterateSlope[l] = (psi[l] + correction[l]) / hGamma;
    }
    if (!residual.evaluate(t, differences.corrected(), iterateSlope, value)) {
      return false;
    }
    for (int l = 0; l < r.length; l++) {
      r[l] = -value[l];
    }
    if (beyondStart && !declarationsSeen) {
      declarationsSeen = true;
      requireAlgebraic(t, differences.corrected(), Math.abs(hGamma));
    }
    return true;
  }

  /**
   * Looks whether F depends on y' of components declared algebraic: its coefficient may have been
   * zero at the start alone. All are moved at once, for one evaluation a run.
   *
   * @throws IllegalArgumentException if it does
   */
  private void requireAlgebraic(double t, double[] y, double hGamma) {
    Manifold manifold = residual.manifold();
    if (asPublished || !manifold.anyAlgebraic() || !linearisation.doubtsDeclarations()) {
      return;
    }
    if (rowThatChanges(t, y, hGamma, -1) < 0) {
      return;
    }
    for (int l = 0; l < y.length; l++) {
      int row = doubtful(l) ? rowThatChanges(t, y, hGamma, l) : -1;
      if (row >= 0) {
        throw new IllegalArgumentException(ResidualJacobians.declaredWrongly(l, row, t));
      }
    }
  }

  private boolean doubtful(int component) {
    Manifold manifold = residual.manifold();
    return manifold.algebraic(component) && manifold.independent(component);
  }

  /**
   * Returns the first row of F that changes if y' of an algebraic component, or for −1 of all, is
   * moved by what moves y in a step by its size, by 1 if that is zero; −1 if none does.
   */
  private int rowThatChanges(double t, double[] y, double hGamma, int component) {
    for (int l = 0; l < y.length; l++) {
      double size = y[l] == 0 ? 1 : Math.abs(y[l] / hGamma);
      boolean moves = doubtful(l) && (component < 0 || component == l);
      ahead[l] = iterateSlope[l] + (moves ? Math.max(Math.abs(iterateSlope[l]), size) : 0);
    }
    residual.evaluateAlways(t, y, ahead, moved);
    for (int l = 0; l < y.length; l++) {
      if (moved[l] != value[l] && Double.isFinite(moved[l]) && Double.isFinite(value[l])) {
        return l;
      }
    }
    return -1;
  }

  @Override
  void substitute(double hGamma, double[] r) {
    linearisation.solve(hGamma, r);
  }

  @Override
  int notFiniteInDerivatives() {
    return linearisation.notFiniteComponent();
  }

  @Override
  int notFiniteInEvaluation() {
    return RightHandSide.firstNotFinite(value);
  }

  /** Takes a derivative for that of the point at which the derivatives of F are formed next. */
  void place(double[] yDot) {
    System.arraycopy(yDot, 0, slope, 0, slope.length);
  }

  /**
   * Factors the matrix whose unknowns are y'_d and y_a, or, if it is singular because F does not
   * determine every y'_d, the nearly equal one of a step that is short; returns whether one of them
   * is regular.
   *
   * @param h the short step, signed
   */
  boolean factorForStart(double h) {
    startHGamma = 0;
    if (factors().factorAnew(0)) {
      return true;
    }
    startHGamma = h;
    return factors().factorAnew(h);
  }

  /** Returns whether the matrix for the start was only replaced by one that is nearly equal. */
  boolean startsApproximately() {
    return startHGamma != 0;
  }

  /**
   * Solves for the changes of y'_d and y_a at the start.
   *
   * @param r −F at entry
   */
  void solveForStart(double[] r) {
    factors().solve(startHGamma, r);
    if (startHGamma == 0) {
      return;
    }
    for (int l = 0; l < r.length; l++) {
      if (!linearisation.algebraic(l)) {
        r[l] /= startHGamma;
      }
    }
  }

  /**
   * y'' from what is left of the equations if y goes on along its slope, which a change of y' has
   * to make up for.
   */
  @Override
  boolean curvature(double t0, double[] y0, double[] slope0, double h, double[] curvature) {
    double stretch = LOOK_AHEAD * h;
    for (int l = 0; l < ahead.length; l++) {
      ahead[l] = y0[l] + stretch * slope0[l];
    }
    if (!valueKnown && !residual.evaluate(t0, y0, slope0, valueAtStart)) {
      return false;
    }
    valueKnown = true;
    if (!residual.evaluateCompleted(t0 + stretch, ahead, slope0, curvature)) {
      return false;
    }
    valueKnown = false;
    for (int l = 0; l < curvature.length; l++) {
      curvature[l] = (valueAtStart[l] - curvature[l]) / stretch;
    }
    if (factorForStart(stretch)) {
      solveForStart(curvature);
    }
    return true;
  }

  @Override
  boolean better(
      double hGamma, double[] before, double part, double[] left, ErrorNorm norm, double small) {
    boolean better = true;
    for (int l = 0; l < left.length; l++) {
      boolean row = Math.abs(left[l]) <= part * Math.abs(before[l]);
      unsolved[l] = row ? 0 : left[l];
      better &= row || left[l] == 0;
    }
    return better || slight.is(unsolved, hGamma, norm, small);
  }

  /** {@inheritDoc} What rounding makes of F shows where y is moved by some rounding errors. */
  @Override
  boolean leftByRounding(double hGamma, BackwardDifferences differences) {
    double[] y = differences.corrected();
    for (int l = 0; l < y.length; l++) {
      ahead[l] = movedByRounding(y, l);
    }
    residual.evaluateAlways(evaluatedTime, ahead, iterateSlope, moved);
    for (int l = 0; l < y.length; l++) {
      boolean explained = Math.abs(unsolved[l]) <= Math.abs(moved[l] + unsolved[l]);
      if (unsolved[l] != 0 && !explained) {
        return false;
      }
    }
    return true;
  }

  @Override
  double roundOff(double hGamma, ErrorNorm norm) {
    if (!factors().factorAnew(hGamma)) {
      return 0;
    }
    double[] moved = ahead;
    for (int l = 0; l < moved.length; l++) {
      moved[l] = Math.ulp(1.0) * linearisation.magnitude(l);
    }
    linearisation.solve(hGamma, moved);
    double size = norm.of(moved);
    return Double.isFinite(size) ? size : 0;
  }

  @Override
  public double cautious(double passing, double interval) {
    return Math.min(FIRST_STEP_PART * passing, FIRST_STEP_SHARE * interval);
  }

  @Override
  double normOfDerivatives(ErrorNorm norm) {
    return 0;
  }

  @Override
  public double fastestMotion() {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean fastestIsExponential() {
    return false;
  }

  @Override
  public boolean allowsCaution() {
    return false;
  }

  @Override
  public double rateOfFastest() {
    return 0;
  }

  @Override
  public double dampingOfFastest() {
    return 0;
  }

  @Override
  public Optional<RightHandSide> rightHandSide() {
    return Optional.empty();
  }

  @Override
  public void testColumns(ColumnTest.Maker tests) {
    linearisation.testColumns(tests);
  }

  @Override
  IterationRules rules(Mode mode) {
    asPublished = mode == Mode.FAITHFUL;
    if (asPublished) {
      return IterationRules.PUBLISHED;
    }
    return (residual.manifold().anyAlgebraic() && !drift().matters())
            || linearisation.allDifferential()
        ? IterationRules.TRUSTING_RESIDUALS
        : IterationRules.LEARNING;
  }

  @Override
  public long evaluations() {
    return residual.evaluations();
  }

  @Override
  void solved(double hGamma, BackwardDifferences differences) {
    double[] psi = differences.psi;
    double[] correction = differences.correction;
    for (int l = 0; l < slope.length; l++) {
      slope[l] = (psi[l] + correction[l]) / hGamma;
    }
    linearisation.knowRate(smallMove / Math.abs(hGamma));
    beyondStart = true;
  }

  @Override
  void transferDerivatives(SavedState state) {
    residual.transfer(state);
    state.numbers(slope);
    linearisation.transfer(state);
    slight.transfer(state);
    start.transfer(state);
    beyondStart = state.flag(beyondStart);
    declarationsSeen = state.flag(declarationsSeen);
  }
}
