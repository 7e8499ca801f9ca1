package org.mechservice.solver.integration;

import java.util.Optional;
import org.mechservice.solver.integration.IntegrationFailure.Cause;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.BandLu;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * ode15s: numerical or backward differentiation formulas of orders 1 to 5 on variable steps, solved
 * by a simplified Newton iteration. The choice for stiff problems.
 *
 * <p>Each component is held to max(rtol |y_i|, atol_i) per step, the steps end at the end of the
 * problem exactly, and no step is longer than a tenth of the interval unless {@link
 * IntegratorSettings#maxStep} says otherwise. A step costs one to four evaluations of f and as many
 * solutions of linear equations; a change of step or order costs a factorisation of I − hγ J. The
 * Jacobian J is kept until an iteration fails with it. It comes from the problem if that is a
 * {@link JacobianSystem}, else from differences, for which atol_i / rtol should be a size of y_i
 * that is small; a {@link BandedSystem} spares the zeros outside of its band. {@link
 * IntegratorSettings#maxOrder} bounds the order; more than 5 means 5.
 *
 * <p>One step is told by {@link #step}: it tries a step of size h and order k until the iteration
 * converges and the error test passes, accepts it, and chooses k and h anew.
 *
 * <p>Formulas of orders 3 to 5 are not stable for weakly damped oscillations that are fast compared
 * with the step: such problems take many steps.
 *
 * <p>Shampine and Reichelt 1997.
 */
public final class Ode15s implements Integrator {
  /** Reduction of a step whose iteration did not converge although the Jacobian was new. */
  private static final double UNSOLVED_REDUCTION = 0.3;

  private final IntegratorSettings settings;
  private final BackwardFormulas formulas;
  private final MaximumNorm norm = new MaximumNorm();
  private final StepsToEnd bounds = new StepsToEnd();
  private final BackwardOrderControl control;
  private final Progress progress = new Progress();

  private StepEquations equations =
      new StepEquations(RightHandSide.none(), new DenseLu(0), new double[0], new double[0]);
  private BackwardDifferences differences = new BackwardDifferences(new double[0], new double[0]);
  private FirstStep firstStep = new FirstStep(new double[0]);

  /** Size and end of the step being tried; size 0 as long as the first is not chosen. */
  private double h;

  private double triedTime;

  /** 1 forwards, −1 backwards in t. */
  private double direction;

  /** Whether a step is begun. */
  private boolean begun;

  /** Size and order that the differences are written for. */
  private double writtenSize;

  private int writtenOrder;

  /**
   * Numerical differentiation formulas.
   *
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15s(IntegratorSettings settings) {
    this(settings, BackwardFormulas.NDF);
  }

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15s(IntegratorSettings settings, BackwardFormulas formulas) {
    settings.requireUsable();
    this.settings = settings;
    this.formulas = formulas;
    control = new BackwardOrderControl(formulas);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException also if the problem's band is wider than its matrix
   */
  @Override
  public StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    IntegratorSettings.requireUsable(t0, tEnd, y0, system.dimension());
    double[] tolerances = settings.absoluteTolerances(y0.length);
    LinearSolver solver = solverFor(system);
    clear(t0);
    RightHandSide rightHandSide = new RightHandSide(system, settings.stop());
    double[] derivative = new double[y0.length];
    rightHandSide.evaluateAlways(t0, y0.clone(), derivative);
    equations = new StepEquations(rightHandSide, solver, smallSizes(tolerances), derivative);
    differences = new BackwardDifferences(y0, derivative);
    firstStep = new FirstStep(derivative);
    norm.begin(settings.relativeTolerance(), tolerances);
    norm.weigh(y0);
    bounds.begin(t0, tEnd, settings.maxStep());
    direction = Math.signum(tEnd - t0);
    int component = RightHandSide.firstNotFinite(derivative);
    return component < 0 ? progress.goOn(t0 == tEnd) : fail(Cause.NOT_FINITE, component);
  }

  /** Returns the size at which the absolute tolerance takes over from the relative one. */
  private double[] smallSizes(double[] absoluteTolerances) {
    double[] sizes = absoluteTolerances.clone();
    for (int l = 0; l < sizes.length; l++) {
      double size = sizes[l] / settings.relativeTolerance();
      sizes[l] = Double.isFinite(size) ? size : sizes[l];
    }
    return sizes;
  }

  private static LinearSolver solverFor(OdeSystem system) {
    int n = system.dimension();
    return system instanceof BandedSystem banded
        ? new BandLu(new BandLayout(n, banded.lowerBandwidth(), banded.upperBandwidth()))
        : new DenseLu(n);
  }

  private void clear(double t0) {
    progress.begin(t0);
    control.begin(settings.highestOrder(BackwardFormulas.HIGHEST_ORDER));
    h = 0;
    triedTime = t0;
    begun = false;
    writtenSize = 1;
    writtenOrder = 1;
  }

  @Override
  public StepResult step() {
    progress.requireRunning();
    while (progress.tries() < settings.maxSteps()) {
      Attempt attempt = tryStep();
      if (attempt == Attempt.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == Attempt.PASSED) {
        accept();
        return progress.goOn(bounds.reachedAt(progress.time()));
      }
      Optional<Cause> cause = repair(attempt);
      if (cause.isPresent()) {
        return fail(cause.get(), limitingComponent(attempt));
      }
    }
    return fail(Cause.TOO_MANY_STEPS, norm.largest(differences.correction));
  }

  /** Linearise, solve, test; what was stopped is taken up where it stood. */
  private Attempt tryStep() {
    Attempt attempt = linearise();
    if (attempt == Attempt.PASSED) {
      attempt = solve();
    }
    return attempt == Attempt.PASSED ? test() : attempt;
  }

  /** Brings Jacobian, size, differences and factors to those of the step being tried. */
  private Attempt linearise() {
    Attempt attempt = equations.linearise(progress.time(), differences.state());
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    if (!begun && !beginStep()) {
      return Attempt.STOPPED;
    }
    writeDifferences();
    return equations.factor(hGamma());
  }

  /** Bounds the step, the first one being chosen before; returns false if told to stop instead. */
  private boolean beginStep() {
    if (h == 0 && !chooseFirstStep()) {
      return false;
    }
    h = bounded(h);
    control.beginStep();
    begun = true;
    return true;
  }

  /**
   * Returns the step to try instead of a proposed one. The smallest size grows with t; a step that
   * was at it and was accepted keeps its size, lest it change at every step and never be outgrown.
   */
  private double bounded(double proposed) {
    double t = progress.time();
    double size = bounds.bounded(t, proposed);
    boolean raised = Math.abs(size) == bounds.smallest(t);
    return raised && proposed == writtenSize ? proposed : size;
  }

  private boolean chooseFirstStep() {
    double t0 = progress.time();
    double longest = bounds.bounded(t0, direction * Double.MAX_VALUE);
    double size = settings.initialStep();
    if (size == 0) {
      size =
          firstStep.size(
              equations,
              t0,
              differences.state(),
              norm,
              longest,
              bounds.smallest(t0),
              settings.relativeTolerance());
    }
    h = Math.copySign(size, longest);
    return size > 0;
  }

  /** Rewrites the differences if size or order has changed. */
  private void writeDifferences() {
    int k = control.order();
    if (h == writtenSize && k == writtenOrder) {
      return;
    }
    differences.rescale(h / writtenSize, k);
    writtenSize = h;
    writtenOrder = k;
    control.rescaled();
    equations.outdate();
  }

  private double hGamma() {
    return h / formulas.leading(control.order());
  }

  /** Predicts and iterates. */
  private Attempt solve() {
    if (!equations.begun()) {
      triedTime = bounds.endOf(progress.time(), h);
      differences.predict(control.order(), formulas);
      norm.weigh(differences.state(), differences.predicted);
      equations.begin(differences, norm);
    }
    return equations.solve(triedTime, hGamma(), differences, norm);
  }

  private Attempt test() {
    control.estimate(differences, norm);
    return control.error() <= 1 ? Attempt.PASSED : Attempt.TOO_INACCURATE;
  }

  private void accept() {
    int k = control.order();
    differences.accept(k);
    progress.accepted(h, triedTime, k, control.error());
    equations.moveOn();
    h *= control.accept(differences, norm);
    begun = false;
  }

  /**
   * Asks for a new Jacobian if that may help, else reduces the step; returns a cause if neither is
   * possible.
   */
  private Optional<Cause> repair(Attempt attempt) {
    boolean inaccurate = attempt == Attempt.TOO_INACCURATE;
    progress.rejected(h, control.order(), inaccurate ? control.error() : Double.NaN, attempt);
    if (progress.notFiniteTooOften()) {
      return Optional.of(Cause.NOT_FINITE);
    }
    if (!inaccurate && equations.renewJacobian()) {
      return Optional.empty();
    }
    double smallest = bounds.smallest(progress.time());
    if (Math.abs(h) <= smallest) {
      return Optional.of(inaccurate ? Cause.STEP_TOO_SMALL : equations.cause(attempt));
    }
    double factor = inaccurate ? control.reject(differences, norm) : UNSOLVED_REDUCTION;
    h = Math.copySign(Math.max(factor * Math.abs(h), smallest), h);
    return Optional.empty();
  }

  private int limitingComponent(Attempt attempt) {
    return attempt == Attempt.TOO_INACCURATE
        ? norm.largest(differences.correction)
        : equations.limitingComponent(attempt, norm);
  }

  private StepResult fail(Cause cause, int component) {
    return progress.fail(cause, h, control.order(), component, norm);
  }

  @Override
  public double time() {
    return progress.time();
  }

  @Override
  public double previousTime() {
    return progress.previousTime();
  }

  @Override
  public double stepSize() {
    return progress.stepSize();
  }

  @Override
  public int order() {
    return progress.order();
  }

  @Override
  public void interpolate(double t, double[] y, double[] yDot) {
    progress.requireInLastStep(t);
    boolean atStart = progress.order() == 0;
    double size = atStart ? 1 : progress.stepSize();
    int k = atStart ? 1 : progress.order();
    BackwardInterpolant.evaluate((t - progress.time()) / size, size, k, differences, y, yDot);
  }

  @Override
  public IntegrationStatistics statistics() {
    return equations.statistics(progress);
  }

  @Override
  public IntegrationFailure failure() {
    return progress.failure();
  }
}
