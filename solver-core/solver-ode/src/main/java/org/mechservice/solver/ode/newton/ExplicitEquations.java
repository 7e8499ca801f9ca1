package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.linear.BlockLu;
import org.mechservice.solver.linear.CondensedLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.CompletedSystem;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.Breakpoints;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * The equations of a step for y' = f(t, y):
 *
 * <pre>
 * (I − hγ J) δ = hγ f(t_{n+1}, y* + d) − (ψ + d);    hγ = h / ((1 − κ_k) γ_k)
 * </pre>
 *
 * <p>J = ∂f/∂y comes from the problem if it is a {@link JacobianSystem}, else from differences; a
 * {@link BandedSystem} spares the zeros outside of its band, a {@link SparseSystem} evaluations for
 * columns that share no row, and operations if it is large. For a {@link CompletedSystem} it is the
 * derivative along completed states.
 */
public final class ExplicitEquations extends StepEquations {
  private static final double SQRT_ROUNDOFF = Math.sqrt(Math.ulp(1.0));

  private final RightHandSide rightHandSide;

  /** The Jacobian that the problem knows. */
  private final Optional<JacobianSystem> known;

  private final JacobianMatrix jacobian;
  private final JacobianDifferences differencing;
  private final CompletedFunction function = new CompletedFunction();
  private final IterationMatrix matrix;

  /** f at the iterate, length n. */
  private final double[] derivative;

  /** Sizes of the terms of the equations, length n. */
  private final double[] terms;

  /** Sizes of what is left of equations that are not solved, length n. */
  private final double[] unsolved;

  /** y moved by rounding errors, then f there, length n. */
  private final double[] moved;

  /** Where f was evaluated last for the iteration. */
  private double evaluatedTime;

  private int notFiniteComponent;

  /** Whether f at a prediction is known from differencing there, and for which time. */
  private boolean predictionKnown;

  private double predictionTime;

  /**
   * @param smallSizes size below which a component is negligible; not modified
   * @param condensing whether equations like q' = v are put into the others before these are solved
   * @throws IllegalArgumentException if the problem's band is wider than its matrix
   */
  public ExplicitEquations(RightHandSide rightHandSide, double[] smallSizes, boolean condensing) {
    super(new Manifold(rightHandSide.system()), MatrixDrift.none());
    this.rightHandSide = rightHandSide;
    OdeSystem system = rightHandSide.system();
    known = system.part(JacobianSystem.class);
    LinearSolver solver = solverFor(system, smallSizes.length, condensing);
    jacobian = new JacobianMatrix(solver.layout());
    differencing =
        new JacobianDifferences(
            solver.layout(),
            ColumnGroups.of(rightHandSide.system(), solver.layout()),
            smallSizes,
            manifold());
    matrix = new IterationMatrix(solver, manifold());
    derivative = new double[smallSizes.length];
    terms = new double[smallSizes.length];
    unsolved = new double[smallSizes.length];
    moved = new double[smallSizes.length];
  }

  private static LinearSolver solverFor(OdeSystem system, int dimension, boolean condensing) {
    if (!condensing
        || system.part(BandedSystem.class).isPresent()
        || IterationMatrix.sparse(system, dimension).isPresent()) {
      return IterationMatrix.solverFor(system, dimension);
    }
    return IterationMatrix.blocks(system, dimension)
        .<LinearSolver>map(blocks -> new BlockLu(blocks, CondensedLu::solverFor))
        .orElseGet(() -> CondensedLu.solverFor(dimension));
  }

  @Override
  public Breakpoints breakpoints() {
    return rightHandSide.breakpoints();
  }

  @Override
  public Optional<RightHandSide> rightHandSide() {
    return Optional.of(rightHandSide);
  }

  @Override
  public void testColumns(ColumnTest.Maker tests) {
    differencing.testColumns(tests);
  }

  @Override
  public boolean stopped() {
    return rightHandSide.stopped();
  }

  @Override
  void abandon() {
    differencing.abandon();
    predictionKnown = false;
  }

  @Override
  public TrialOutcome findStart(double t, double[] y, double[] slope) {
    boolean complete = manifold().complete(t, y);
    rightHandSide.evaluateAlways(t, y, slope);
    if (!complete) {
      return TrialOutcome.NOT_COMPLETED;
    }
    differencing.knowValue(slope);
    notFiniteComponent = RightHandSide.firstNotFinite(slope);
    return notFiniteComponent < 0 ? TrialOutcome.PASSED : TrialOutcome.NOT_FINITE;
  }

  @Override
  public Cause causeAtStart(TrialOutcome attempt) {
    return attempt == TrialOutcome.NOT_COMPLETED ? Cause.NOT_COMPLETED : Cause.NOT_FINITE;
  }

  @Override
  public int componentAtStart(TrialOutcome attempt) {
    return attempt == TrialOutcome.NOT_COMPLETED ? -1 : notFiniteComponent;
  }

  @Override
  TrialOutcome formDerivatives(double t, double[] y) {
    TrialOutcome attempt =
        known.isPresent() ? evaluateKnown(known.get(), t, y) : evaluateByDifferences(t, y);
    if (attempt == TrialOutcome.PASSED) {
      jacobian.replace();
    }
    return attempt;
  }

  private TrialOutcome evaluateKnown(JacobianSystem system, double t, double[] y) {
    if (rightHandSide.stopped()) {
      return TrialOutcome.STOPPED;
    }
    system.jacobian(breakpoints().inside(t), y, jacobian.formingFromZero());
    notFiniteComponent = jacobian.rowNotFinite();
    return notFiniteComponent < 0 ? TrialOutcome.PASSED : TrialOutcome.NOT_FINITE;
  }

  private TrialOutcome evaluateByDifferences(double t, double[] y) {
    function.t = t;
    differencing.runTime(breakpoints().direction());
    TrialOutcome attempt =
        differencing.evaluate(function, y, differencing.value(), jacobian.forming());
    notFiniteComponent = differencing.notFiniteComponent();
    return attempt;
  }

  @Override
  boolean formsMatrix() {
    return false;
  }

  @Override
  TrialOutcome formMatrix(double t, double[] y, double hGamma) {
    return formDerivatives(t, y);
  }

  @Override
  TrialOutcome formAhead(double t, double hGamma, BackwardDifferences differences) {
    if (manifold().completes()) {
      System.arraycopy(differences.predicted, 0, moved, 0, moved.length);
      if (!manifold().complete(t, moved)) {
        return TrialOutcome.NOT_COMPLETED;
      }
    }
    TrialOutcome attempt = formDerivatives(t, differences.predicted);
    predictionKnown = attempt == TrialOutcome.PASSED && known.isEmpty();
    predictionTime = t;
    return attempt;
  }

  @Override
  boolean formFactors(double hGamma) {
    return matrix.factorExplicit(hGamma, jacobian.values());
  }

  @Override
  int singularComponent() {
    return matrix.singularColumn();
  }

  @Override
  double reciprocalCondition() {
    return matrix.reciprocalCondition();
  }

  @Override
  boolean evaluate(double t, double hGamma, BackwardDifferences differences, double[] residual) {
    evaluatedTime = t;
    if (knownFromDifferencing(t, differences)) {
      System.arraycopy(differencing.value(), 0, derivative, 0, derivative.length);
    } else if (!rightHandSide.evaluate(t, differences.corrected(), derivative)) {
      return false;
    }
    double[] psi = differences.psi;
    double[] correction = differences.correction;
    for (int l = 0; l < residual.length; l++) {
      residual[l] = hGamma * derivative[l] - (psi[l] + correction[l]);
    }
    if (manifold().completes()) {
      manifold().clearPassive(residual);
    }
    return true;
  }

  /** Returns, once, whether f was evaluated for the same state before. */
  private boolean knownFromDifferencing(double t, BackwardDifferences differences) {
    boolean same =
        predictionKnown
            && t == predictionTime
            && Arrays.equals(differences.corrected(), differences.predicted);
    predictionKnown = false;
    return same;
  }

  @Override
  void substitute(double hGamma, double[] residual) {
    matrix.solve(residual);
  }

  @Override
  int notFiniteInDerivatives() {
    return notFiniteComponent;
  }

  @Override
  int notFiniteInEvaluation() {
    return RightHandSide.firstNotFinite(derivative);
  }

  @Override
  boolean better(
      double hGamma, double[] before, double part, double[] left, ErrorNorm norm, double small) {
    boolean better = true;
    for (int l = 0; l < left.length; l++) {
      double size = Math.abs(left[l]);
      boolean row = size <= part * Math.abs(before[l]) || size * norm.weight(l) <= small;
      unsolved[l] = row ? 0 : size;
      better &= row;
    }
    return better;
  }

  @Override
  boolean slight(double[] left, ErrorNorm norm, double small) {
    return norm.of(left) <= small;
  }

  /**
   * {@inheritDoc} A Jacobian of a steeper place explains anything: what it says of rounding errors
   * is believed where y moved by some moves f as much.
   */
  @Override
  boolean leftByRounding(double hGamma, BackwardDifferences differences) {
    double[] y = differences.corrected();
    Arrays.fill(terms, 0);
    jacobian.addMagnitudes(y, terms);
    boolean steep = false;
    for (int l = 0; l < terms.length; l++) {
      double ofSlopes = Math.abs(hGamma) * terms[l];
      double others = Math.abs(hGamma * derivative[l]) + Math.abs(y[l]);
      others += Math.abs(differences.psi[l]);
      if (unsolved[l] > ROUNDOFF_OF_TERMS * (ofSlopes + others)) {
        return false;
      }
      steep |= unsolved[l] > ROUNDOFF_OF_TERMS * others;
      terms[l] = others;
    }
    return !steep || movesByRounding(hGamma, y);
  }

  private boolean movesByRounding(double hGamma, double[] y) {
    for (int l = 0; l < y.length; l++) {
      moved[l] = movedByRounding(y, l);
    }
    function.t = evaluatedTime;
    function.evaluateAlways(moved, moved);
    for (int l = 0; l < terms.length; l++) {
      double change = Math.abs(hGamma * (moved[l] - derivative[l]));
      if (!(unsolved[l] <= ROUNDOFF_OF_TERMS * terms[l] + change)) {
        return false;
      }
    }
    return true;
  }

  /** {@inheritDoc} In h f they vanish with the step. */
  @Override
  double roundOff(double hGamma, ErrorNorm norm) {
    return 0;
  }

  /** y'' = ∂f/∂t + J f, the former by a difference. */
  @Override
  boolean curvature(double t0, double[] y0, double[] slope, double h, double[] curvature) {
    double stretch = SQRT_ROUNDOFF * Math.max(Math.abs(t0), Math.abs(t0 + h));
    double after = t0 + Math.copySign(Math.min(stretch, Math.abs(h)), h);
    if (!rightHandSide.evaluate(after, y0, curvature)) {
      return false;
    }
    for (int l = 0; l < slope.length; l++) {
      curvature[l] = (curvature[l] - slope[l]) / (after - t0);
    }
    jacobian.addProduct(slope, curvature);
    return true;
  }

  @Override
  public double cautious(double passing, double interval) {
    return passing;
  }

  @Override
  double normOfDerivatives(ErrorNorm norm) {
    return jacobian.norm(norm);
  }

  @Override
  public double fastestMotion() {
    return jacobian.spectralRadius();
  }

  @Override
  public boolean fastestIsExponential() {
    return jacobian.fastestIsExponential();
  }

  @Override
  public boolean allowsCaution() {
    return true;
  }

  @Override
  public double rateOfFastest() {
    return jacobian.rateOfFastest();
  }

  @Override
  public double dampingOfFastest() {
    return jacobian.dampingOfFastest();
  }

  @Override
  double costOfDerivatives() {
    return differencing.evaluations();
  }

  @Override
  IterationRules rules(Mode mode) {
    return mode == Mode.FAITHFUL ? IterationRules.PUBLISHED : IterationRules.TRUSTING;
  }

  @Override
  public long evaluations() {
    return rightHandSide.evaluations();
  }

  @Override
  void solved(double hGamma, BackwardDifferences differences) {}

  @Override
  void transferDerivatives(SavedState state) {
    rightHandSide.transfer(state);
    manifold().refresh();
    jacobian.transfer(state);
    differencing.transfer(state);
  }

  /** f at a state whose passive components are made to fit first. */
  private final class CompletedFunction implements DifferencedFunction {
    private final double[] completed = new double[manifold().dimension()];
    private double t;

    @Override
    public boolean evaluate(double[] x, double[] value) {
      if (!manifold().completes()) {
        return rightHandSide.evaluate(t, x, value);
      }
      if (rightHandSide.stopped()) {
        return false;
      }
      evaluateAlways(x, value);
      return true;
    }

    void evaluateAlways(double[] x, double[] value) {
      System.arraycopy(x, 0, completed, 0, x.length);
      if (manifold().complete(t, completed)) {
        rightHandSide.evaluateAlways(t, completed, value);
      } else {
        Arrays.fill(value, Double.NaN);
      }
    }
  }
}
